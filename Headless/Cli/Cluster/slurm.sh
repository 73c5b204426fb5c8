#!/usr/bin/env bash
# {{name}}: {{contents}}. Where sbatch is: bash THIS_FILE
# Submitted once more, it does what is missing: a task that is done ends at once.
#SBATCH --cpus-per-task={{cores}}
#SBATCH --mem={{mebibytes}}M
#SBATCH --time={{minutes}}
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --signal=B:TERM@60
# Where nodes say how much disk they have: --tmp={{gibibytes}}G
{{partition}}
set -u
fastpoints={{program}}
plan={{plan}}
scratch={{scratch}}
attempts={{attempts}}

if [ $# -eq 0 ]; then
  set -e
  after= jobs=
  submit() { # name, what an array is numbered, what a task does
    local id
    id=$(sbatch --parsable --job-name="$1" ${2:+--array="$2"} --output="$1${2:+-%a}.log" \
      ${after:+--dependency="afterok$after" --kill-on-invalid-dep=yes} "$0" "${@:3}")
    jobs+=:${id%%;*}
    echo "$1: job ${id%%;*}"
  }
  behind() { after=$jobs jobs=; }
{{submissions}}  exit
fi

# The shell is told a minute before the time is up; the task ends then so that it can go on.
task=
trap 'kill -TERM "$task" 2>/dev/null' TERM
"$fastpoints" "$@" --threads "$SLURM_CPUS_PER_TASK" --scratch "$scratch" --quiet &
task=$!
wait "$task"
status=$?
while kill -0 "$task" 2>/dev/null; do
  wait "$task"
  status=$?
done
# Bad input (3) and a bad command (2) would be so again, and what was cancelled is no longer running.
case $status in 0 | 2 | 3) exit "$status" ;; esac
job=${SLURM_ARRAY_JOB_ID:+${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID}
job=${job:-$SLURM_JOB_ID}
if [ "${SLURM_RESTART_COUNT:-0}" -lt "$attempts" ] && [ "$(squeue -h -j "$job" -o %T)" = RUNNING ]; then
  scontrol requeue "$job"
fi
exit "$status"
