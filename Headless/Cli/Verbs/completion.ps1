Register-ArgumentCompleter -Native -CommandName fastpoints -ScriptBlock {
  param($word, $line, $at)
  $program = $line.CommandElements[0].Value
  $typed = $line.ToString().Substring($program.Length).TrimStart()
  & $program "[suggest:$($at - $line.Extent.StartOffset - $program.Length - 1)]" $typed |
    Where-Object { $_ -like "$word*" } |
    ForEach-Object { [System.Management.Automation.CompletionResult]::new($_, $_, 'ParameterValue', $_) }
}
