namespace FastPoints.Cli.Verbs;

public sealed class ClusterVerb : Verb
{
    const string Slurm = "slurm", Kubernetes = "kubernetes", Batch = "aws-batch";

    readonly Argument<string> m_kind = new("SCHEDULER") { Description = Slurm + ", " + Kubernetes + " or " + Batch + "." };
    readonly Argument<string> m_plan = new("PLAN.json")
    {
        Description = "What plan wrote, where tasks see it too: a path that all nodes have, an address, s3://bucket/key.",
    };
    readonly Option<long> m_cores = Counts.Of("--cores", "Cores of a task.", 4);
    readonly Option<long> m_attempts = Counts.Of("--attempts",
        "How often a task is tried; never again where its input is bad.", 10);
    readonly Option<long?> m_maxArray = Counts.Optional("--max-array",
        "Tasks of an array at most (default: 1001 of Slurm's MaxArraySize, 100,000 of Kubernetes, 10,000 of Batch).");
    readonly Option<long?> m_atOnce = Counts.Optional("--at-once",
        "Tasks of an array that run at once at most (Slurm, Kubernetes: 100).");
    readonly ValueOption<string?> m_queue = new("--queue", "NAME", "Slurm's partition, Batch's job queue.");
    readonly ValueOption<string?> m_image = new("--image", "NAME",
        "The container that has fastpoints, for Kubernetes and Batch.");
    readonly ValueOption<string?> m_volume = new("--volume", "NAME:PATH",
        "Where plan and store lie if they have no address: a claim of Kubernetes or a file system of EFS, and where tasks "
            + "see it.");
    readonly ValueOption<string?> m_scratch = new("--scratch", "DIR",
        "A task's temporary files, on the node's own disk (default: Slurm: SLURM_TMPDIR, TMPDIR or /tmp; in a container "
            + "/scratch).");
    readonly ValueOption<string?> m_program = new("--program", "PATH",
        "What is run there (default: Slurm: this program; in a container fastpoints).");

    public ClusterVerb() : base(new Command("cluster", "Print a job script of Slurm or AWS Batch or a manifest of Kubernetes for "
        + "a plan: arrays of tasks, one stage behind the other, with memory, disk, time and retries. Read it, then submit it."))
    {
        Command.Add(m_kind, m_plan, m_cores, m_attempts, m_maxArray, m_atOnce, m_queue, m_image, m_volume, m_scratch, m_program);
    }

    public override IReadOnlyList<(string, string)> Examples =>
    [
        ("./fastpoints cluster slurm town.json > town.sh", "then: bash town.sh"),
        ("./fastpoints cluster kubernetes s3://b/town.json --image I", "its first lines say how it is applied"),
    ];

    public override void Run(ParseResult parsed, CliRun run)
    {
        string kind = parsed.GetRequiredValue(m_kind), plan = parsed.GetRequiredValue(m_plan);
        (int max, bool isContainer) = kind switch
        {
            Slurm => (1001, false),
            Kubernetes => (100_000, true),
            Batch => (10_000, true),
            _ => throw new UsageException("cluster: wanted " + Slurm + ", " + Kubernetes + " or " + Batch + ", got " + kind),
        };
        var settings = Read(parsed, max, isContainer);
        if (isContainer && settings.Image == null)
            throw new UsageException(kind + " needs --image");
        if (kind == Batch && settings.Queue == null)
            throw new UsageException(kind + " needs --queue");
        run.Begin([plan]);
        var job = ClusterJob.Of(BuildPlan.Read(plan));
        if (isContainer && settings.Volume == null && !SourcePath.IsRemote(plan))
            throw new UsageException(plan + ": containers see no path of this machine: give an address, or --volume");
        run.Out.Write((kind switch
        {
            Slurm => SlurmScript.Of(job, settings),
            Kubernetes => KubernetesManifest.Of(job, settings),
            _ => AwsBatchScript.Of(job, settings),
        }).ReplaceLineEndings("\n"));
    }

    ClusterSettings Read(ParseResult parsed, int max, bool isContainer)
    {
        string? program = Environment.ProcessPath, volume = parsed.GetValue(m_volume);
        string[] parts = volume?.Split(':', 2) ?? [];
        if (volume != null && (parts.Length < 2 || parts[0].Length == 0 || !parts[1].StartsWith('/')))
            throw new UsageException("--volume: wanted NAME:PATH, got " + volume);
        return new ClusterSettings(
            parsed.GetValue(m_program)
                ?? (isContainer || Path.GetFileName(program) is null or "dotnet" ? "fastpoints" : program!),
            Counts.ToInt(parsed.GetValue(m_cores)), Counts.ToInt(Math.Min(10, parsed.GetValue(m_attempts))),
            Counts.ToInt(parsed.GetValue(m_maxArray) ?? max),
            parsed.GetValue(m_atOnce) is { } n ? Counts.ToInt(n) : null, parsed.GetValue(m_queue), parsed.GetValue(m_image),
            parsed.GetValue(m_scratch), volume == null ? null : (parts[0], parts[1]));
    }
}
