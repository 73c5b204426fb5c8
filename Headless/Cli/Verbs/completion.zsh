_fastpoints() {
  local -a known
  local at=$((CURSOR - ${#words[1]} - 1))
  known=("${(@f)$("${words[1]}" "[suggest:$at]" "${BUFFER#"${words[1]} "}" 2>/dev/null)}")
  compadd -a known
  _files
}
compdef _fastpoints fastpoints ./fastpoints
