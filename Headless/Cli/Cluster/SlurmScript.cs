namespace FastPoints.Cli.Cluster;

/// <summary>One script, which submits itself: array by array, each stage behind the one before.</summary>
static class SlurmScript
{
    public static string Of(ClusterJob job, ClusterSettings settings) => $$"""
        #!/usr/bin/env bash
        # {{job.Name}}: {{job.Contents}}. Where sbatch is: bash THIS_FILE
        # Submitted once more, it does what is missing: a task that is done ends at once.
        #SBATCH --cpus-per-task={{settings.Cores}}
        #SBATCH --mem={{job.NodeMebibytes}}M
        #SBATCH --time={{job.LimitMinutes}}
        #SBATCH --requeue
        #SBATCH --open-mode=append
        #SBATCH --signal=B:TERM@60
        # Where nodes say how much disk they have: --tmp={{job.ScratchGibibytes}}G
        {{(settings.Queue == null ? "##SBATCH --partition=NAME" : "#SBATCH --partition=" + settings.Queue)}}
        set -u
        fastpoints={{Quoted(settings.Program)}}
        plan={{Quoted(job.Plan)}}
        scratch={{(settings.Scratch == null ? "${SLURM_TMPDIR:-${TMPDIR:-/tmp}}" : Quoted(settings.Scratch))}}
        attempts={{settings.Attempts}}

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
        {{Submissions(job, settings)}}  exit
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

        """;

    static string Submissions(ClusterJob job, ClusterSettings settings)
    {
        var text = new StringBuilder();
        foreach (var stage in job.Stages)
        {
            if (stage != job.Stages[0])
                text.Append("  behind\n");
            foreach (var array in stage.Arrays(settings.MaxArray))
            {
                string indices = stage.IsNumbered ? "0-" + (array.Tasks - 1) + (settings.AtOnce is { } n ? "%" + n : "") : "''";
                text.Append("  submit " + job.Name + "-" + array.Name + " " + indices + " "
                    + string.Join(" ", array.Words("\"$plan\"")) + "\n");
            }
        }
        return text.ToString();
    }

    internal static string Quoted(string word) => "'" + word.Replace("'", "'\\''", StringComparison.Ordinal) + "'";
}
