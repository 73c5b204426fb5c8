namespace FastPoints.Cli.Cluster;

/// <summary>One script, which submits itself: array by array, each stage behind the one before.</summary>
static class SlurmScript
{
    public static string Of(ClusterJob job, ClusterSettings settings) => EmbeddedText.Of("slurm.sh",
        ("name", job.Name), ("contents", job.Contents), ("cores", settings.Cores), ("mebibytes", job.TaskMebibytes),
        ("minutes", job.TaskLimitMinutes), ("gibibytes", job.ScratchGibibytes),
        ("partition", settings.Queue == null ? "##SBATCH --partition=NAME" : "#SBATCH --partition=" + settings.Queue),
        ("program", Quoted(settings.Program)), ("plan", Quoted(job.Plan)), ("attempts", settings.Attempts),
        ("scratch", settings.Scratch == null ? "${SLURM_TMPDIR:-${TMPDIR:-/tmp}}" : Quoted(settings.Scratch)),
        ("submissions", Submissions(job, settings)));

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
