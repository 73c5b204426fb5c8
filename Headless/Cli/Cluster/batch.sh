#!/usr/bin/env bash
# {{name}}: {{contents}}. With AWS' command line: bash THIS_FILE
# Submitted once more, it does what is missing: a task that is done ends at once.
set -eu
queue={{queue}}
definition=$(aws batch register-job-definition --query jobDefinitionArn --output text \
  --cli-input-json '{{definition}}')

after='[]' jobs=
submit() { # name, tasks, what a task does as JSON
  local id size=()
  if [ "$2" -gt 1 ]; then size=(--array-properties "size=$2"); fi
  id=$(aws batch submit-job --job-name "$1" --job-queue "$queue" --job-definition "$definition" ${size[@]+"${size[@]}"} \
    --depends-on "$after" --container-overrides "{\"command\": $3}" --query jobId --output text)
  jobs+=${jobs:+, }"{\"jobId\": \"$id\"}"
  echo "$1: job $id"
}
behind() { after="[$jobs]" jobs=; }
