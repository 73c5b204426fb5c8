#!/usr/bin/env bash
# A cloud built by Debian's Slurm, of one node on the loopback: what "cluster slurm" prints is submitted as it is, while tasks are
# killed and requeued, the node goes down, a disk is full and a task runs twice. It must be the cloud that one machine builds, byte by
# byte. As root it installs Slurm by apt-get. The last line is "N passed, N failed" (", N skipped").
#   Headless/slurm.sh [SEED]   of the moments at which tasks are killed; default: the time
set -uo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root" || exit 1
. Headless/sdk.sh

packages=slurm-wlm
has_slurm() { [ -x /usr/sbin/slurmctld ] && [ -x /usr/sbin/slurmd ] && command -v sbatch >/dev/null 2>&1; }
if ! has_slurm && ! apt_install $packages; then
  echo "no Slurm here; with root: apt-get install $packages"
  echo "0 passed, 0 failed, 1 skipped"
  exit 0
fi
require_sdk slurm.sh

kills=20
full="No space left on device\|too little room"
seed=${1:-$(date +%s)}
RANDOM=$seed
scratch=$(mktemp -d)
fastpoints=$root/Headless/artifacts/fastpoints/FastPoints.Cli
passed=0 failed=0 skipped=0 servers=() mounted=
mkdir -p "$scratch"/{state,spool,tmp,jobs}
export SLURM_CONF=$scratch/slurm.conf TMPDIR=$scratch/tmp

# No daemon of authentication, no cgroups: the user who runs this may do all. The cores are shared, so that tasks run at once on any
# machine. What is requeued starts again after a credential's life, which is two minutes otherwise.
write_config() { # port
  cat >"$SLURM_CONF" <<END
ClusterName=fastpoints
SlurmctldHost=localhost
SlurmctldPort=$1
SlurmdPort=$(($1 + 1))
AuthType=auth/none
CredType=cred/none
AuthInfo=cred_expire=5
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
StateSaveLocation=$scratch/state
SlurmdSpoolDir=$scratch/spool
SlurmctldPidFile=$scratch/slurmctld.pid
SlurmdPidFile=$scratch/slurmd.pid
SlurmdParameters=config_overrides
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SwitchType=switch/none
MailProg=/bin/true
SchedulerParameters=bf_interval=1,sched_interval=1
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
TaskProlog=$scratch/prolog
KillWait=10
MinJobAge=86400
NodeName=localhost NodeAddr=127.0.0.1 CPUs=4 RealMemory=65536 State=UNKNOWN
PartitionName=main Nodes=localhost Default=YES State=UP
END
  # As clusters name the node's own disk; one task gets a small one, until that was full.
  cat >"$scratch/prolog" <<END
#!/bin/sh
name=\$SLURM_JOB_NAME-\$SLURM_ARRAY_TASK_ID
if [ "\$name" = "\$(cat $scratch/small.task 2>/dev/null)" ] && ! grep -q "$full" "$scratch/jobs/\$name.log"; then
  echo "export SLURM_TMPDIR=$scratch/small"
fi
END
  chmod +x "$scratch/prolog"
}

start_slurm() {
  local second
  /usr/sbin/slurmctld -D -c >"$scratch/slurmctld.log" 2>&1 </dev/null &
  servers+=($!)
  /usr/sbin/slurmd -D -N localhost >"$scratch/slurmd.log" 2>&1 </dev/null &
  servers+=($!)
  for second in {1..30}; do
    sleep 1
    if [ "$(sinfo -h -o %T 2>/dev/null)" = idle ]; then return 0; fi
  done
  cat "$scratch/slurmctld.log" "$scratch/slurmd.log"
  return 1
}

stop_all() {
  scancel --quiet -u "$(id -un)" >/dev/null 2>&1
  if [ ${#servers[@]} -gt 0 ]; then
    sleep 1
    kill "${servers[@]}" 2>/dev/null
    wait "${servers[@]}" 2>/dev/null
  fi
  if [ -n "$mounted" ]; then umount "$scratch/small"; fi
  rm -rf "$scratch"
}
trap stop_all EXIT

check() { # name, command...
  local name=$1 start=$SECONDS
  shift
  if "$@" >"$scratch/check.log" 2>&1 </dev/null; then
    passed=$((passed + 1))
    echo "-- $name: $((SECONDS - start)) s"
  else
    failed=$((failed + 1))
    echo "FAILED: $name"
    tail -n 40 "$scratch/check.log" | sed 's/^/    /'
    return 1
  fi
}

finish() {
  echo "-- slurm: $SECONDS s, seed $seed"
  echo "$passed passed, $failed failed$([ "$skipped" -gt 0 ] && echo ", $skipped skipped")"
  [ "$failed" -eq 0 ]
  exit
}

submit() { # script; the jobs' numbers by name are in $scratch/jobs/ids
  (cd "$scratch/jobs" && bash "$1") | tee "$scratch/jobs/ids"
  [ "${PIPESTATUS[0]}" -eq 0 ]
}
id_of() { sed -n "s/^$1: job //p" "$scratch/jobs/ids"; }
states() { squeue -h -t all -r -o "%j %i %T" | grep "^$1"; } # of jobs and tasks whose names begin so
is_idle() { [ -z "$(squeue -h)" ]; }
await_idle() { # seconds
  local end=$((SECONDS + $1))
  until is_idle; do
    if [ $SECONDS -ge $end ]; then squeue; return 1; fi
    sleep 0.5
  done
}
field() { scontrol show job "$1" | tr ' ' '\n' | sed -n "s/^$2=//p" | head -n 1; } # job, name

# A task that runs, but none that was hit so often that its script would give it up soon.
pick_task() {
  local tasks task
  mapfile -t tasks < <(squeue -h -r -t RUNNING -o %i | grep _)
  [ ${#tasks[@]} -gt 0 ] || return 1
  task=${tasks[RANDOM % ${#tasks[@]}]}
  [ "$(field "$task" Restarts)" -lt 6 ] && echo "$task"
}
pid_of() { # number of a task's own job
  local at
  for at in $(grep -lzx "SLURM_JOB_ID=$1" /proc/[0-9]*/environ 2>/dev/null); do
    if grep -qzxF "$fastpoints" "${at%environ}cmdline" 2>/dev/null; then basename "${at%/environ}"; return; fi
  done
  return 1
}

# As it happens: a process dies, a job is requeued, a job's time is up. Each time one that runs, at a random moment.
disturb() { # how often
  local done=0 task pid end=$((SECONDS + 600))
  while [ $done -lt "$1" ] && [ $SECONDS -lt $end ]; do
    sleep "0.$((RANDOM % 50 + 10))"
    task=$(pick_task) && pid=$(pid_of "$(field "$task" JobId)") || continue
    case $((RANDOM % 3)) in
      0) kill -9 "$pid" || continue ;;
      1) scontrol requeue "$task" || continue ;;
      2) scancel --batch --signal=TERM "$task" || continue ;;
    esac
    done=$((done + 1))
  done
  echo "$done disturbances"
  [ $done -eq "$1" ]
}

write_config $((20000 + RANDOM % 20000))
if ! check "Slurm starts" start_slurm; then finish; fi
./fastpoints --version >/dev/null || finish

# The points of each task may be anywhere in the file, so that it takes some seconds.
make_plan() {
  local same=(--quiet --sampler poisson --chunk-points 100k)
  "$fastpoints" demo-cloud --quiet -o "$scratch/one.las" --points 8M --seed 5 &&
    "$fastpoints" demo-cloud --quiet -o "$scratch/cloud.las" --tile "$scratch/one.las" --times 9 &&
    "$fastpoints" convert "$scratch/cloud.las" -o "$scratch/whole.fastpoints" "${same[@]}" &&
    "$fastpoints" plan "$scratch/cloud.las" -o "$scratch/cloud.json" --store "$scratch/many.fastpoints" --cells --task-points 4M "${same[@]}"
}
if ! check "plan" make_plan; then finish; fi
tasks=$(grep -o '"tasks": *[0-9]*' "$scratch/cloud.json" | head -n 1 | grep -o '[0-9]*$')
echo "$tasks tasks"
"$fastpoints" cluster slurm "$scratch/cloud.json" --cores 1 --max-array 10 --attempts 1000 >"$scratch/cloud.sh"

# What is cancelled stays so.
cancel_all() {
  submit "$scratch/cloud.sh" || return 1
  until [ -n "$(ls "$scratch"/many.fastpoints/*/build-*.json 2>/dev/null)" ]; do sleep 0.2; done
  scancel -u "$(id -un)"
  await_idle 30 && sleep 8 && is_idle
}
check "what is cancelled does not come back" cancel_all

# Submitted again while 20 times something happens.
copies() { # one task twice at once, beside Slurm's
  local pids=() pid
  for pid in 1 2; do
    "$fastpoints" build "$scratch/cloud.json" --task "$((tasks - 1))" --threads 1 --quiet &
    pids+=($!)
  done
  for pid in "${pids[@]}"; do wait "$pid" || return 1; done
}
small_disk() {
  mkdir -p "$scratch/small" && mount -t tmpfs -o size=1m none "$scratch/small" 2>/dev/null && mounted=yes
}
if [ "$(id -u)" -eq 0 ] && small_disk; then
  # A task that is not done yet.
  small=$((tasks - 2))
  echo "cloud-build-$((small / 10 * 10))-$((small % 10))" >"$scratch/small.task"
else
  skipped=$((skipped + 1))
  echo "skipped: a full disk, without the right to mount one"
fi
check "submitted again" submit "$scratch/cloud.sh" || finish
copies >"$scratch/copies.log" 2>&1 </dev/null &
copies=$!
check "$kills kills, requeues and signals" disturb $kills
node_down() {
  scontrol update nodename=localhost state=down reason=test && sleep 2 && [ -z "$(squeue -h -t RUNNING)" ] &&
    scontrol update nodename=localhost state=resume
}
node_drained() {
  scontrol update nodename=localhost state=drain reason=test && sleep 3 && scontrol update nodename=localhost state=resume
}
check "the node goes down, and comes back" node_down
check "the node is drained, and resumed" node_drained
check "two copies of one task" wait $copies
is_committed() { [ "$(field "$(id_of cloud-commit)" JobState)" = COMPLETED ]; }
# What Slurm itself lost (it may delete the script of a job that it starts again so soon) is submitted again, as a user would.
ended() {
  await_idle 600 || return 1
  if ! is_committed && grep -l 'slurm_script: No such file' "$scratch"/jobs/*.log; then
    submit "$scratch/cloud.sh" && await_idle 300
  fi
  is_committed
}
check "all tasks, merges and the commit" ended || { states cloud-; tail -n 5 "$scratch"/jobs/*.log; finish; }
if [ -n "$mounted" ]; then
  check "a full disk is said, and the task goes elsewhere" grep -rq "$full" "$scratch/jobs"
fi
# Bad input is bad on any node.
bad_input() {
  local task
  "$fastpoints" demo-cloud --quiet -o "$scratch/bad.laz" --points 100k &&
    "$fastpoints" plan --quiet "$scratch/bad.laz" -o "$scratch/bad.json" --store "$scratch/bad.fastpoints" --chunk-points 10k &&
    truncate -s 1000 "$scratch/bad.laz" &&
    "$fastpoints" cluster slurm "$scratch/bad.json" --cores 1 >"$scratch/bad.sh" && submit "$scratch/bad.sh" && await_idle 60 || return 1
  task=$(id_of bad-build)_0
  scontrol show job "$task"
  [ "$(field "$task" ExitCode)/$(field "$task" Restarts)" = 3:0/0 ] && [ "$(field "$(id_of bad-commit)" JobState)" = CANCELLED ]
}
check "bad input is tried once, and nothing comes behind it" bad_input
check "the same bytes as one machine's" diff -r "$scratch/whole.fastpoints" "$scratch/many.fastpoints"
check "verify" "$fastpoints" verify --quiet "$scratch/many.fastpoints" --against "$scratch/cloud.las"
check "picture" "$fastpoints" picture --quiet "$scratch/many.fastpoints" -o "$scratch/picture.png"
finish
