function __fastpoints
  set -l words (commandline -opc)
  set -l line (string replace -- "$words[1] " "" (commandline -cp))
  $words[1] "[suggest:"(string length -- "$line")"]" "$line" 2>/dev/null
end
complete -c fastpoints -a "(__fastpoints)"
