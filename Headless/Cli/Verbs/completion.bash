_fastpoints() {
  local IFS=$'\n' program=${COMP_WORDS[0]}
  local at=$((COMP_POINT - ${#program} - 1))
  local known="$("$program" "[suggest:$at]" "${COMP_LINE#"$program "}" 2>/dev/null)"
  COMPREPLY=($(compgen -W "$known" -- "${COMP_WORDS[COMP_CWORD]}"))
}
complete -o default -F _fastpoints fastpoints ./fastpoints
