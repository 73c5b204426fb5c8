namespace FastPoints.Cli.Cluster;

/// <summary>A Job an array; which comes behind which is for whoever applies them, by their labels.</summary>
static class KubernetesManifest
{
    public static string Of(ClusterJob job, ClusterSettings settings)
    {
        var text = new StringBuilder(EmbeddedText.Of("kubernetes.yaml", ("name", job.Name),
            ("contents", job.Contents), ("stages", string.Join(" ", job.Stages.Select(s => s.Name)))));
        foreach (var stage in job.Stages)
            foreach (var array in stage.Arrays(settings.MaxArray))
                text.Append(Job(job, array, settings));
        return text.ToString();
    }

    static string Job(ClusterJob job, ClusterArray array, ClusterSettings settings) => EmbeddedText.Of("kubernetes-job.yaml",
        ("name", job.Name), ("array", array.Name), ("stage", array.Stage.Name), ("tasks", array.Tasks),
        ("parallelism", Math.Min(array.Tasks, settings.AtOnce ?? 100)), ("attempts", settings.Attempts),
        ("image", JsonOf(settings.Image!)), ("command", Lines(Command(job, array, settings))), ("cores", settings.Cores),
        ("mebibytes", job.TaskMebibytes), ("gibibytes", job.ScratchGibibytes), ("scratch", JsonOf(ScratchOf(settings))),
        ("mount", VolumeMount(settings))) + Volume(settings);

    public static string ScratchOf(ClusterSettings settings) => settings.Scratch ?? "/scratch";

    public static IEnumerable<string> Command(ClusterJob job, ClusterArray array, ClusterSettings settings) =>
    [
        settings.Program, .. array.Words(job.Plan),
        "--threads", settings.Cores.ToString(CultureInfo.InvariantCulture), "--scratch", ScratchOf(settings), "--quiet",
    ];

    /// <summary>Texts of JSON are texts of YAML.</summary>
    public static string JsonOf(string text) =>
        "\"" + JsonEncodedText.Encode(text, JavaScriptEncoder.UnsafeRelaxedJsonEscaping) + "\"";

    static string Lines(IEnumerable<string> words) => string.Concat(words.Select(w => "        - " + JsonOf(w) + "\n"));

    static string VolumeMount(ClusterSettings settings) => settings.Volume is not var (_, path) ? ""
        : "        - {name: data, mountPath: " + JsonOf(path) + "}\n";

    static string Volume(ClusterSettings settings) => settings.Volume is not var (name, _) ? ""
        : "      - name: data\n        persistentVolumeClaim: {claimName: " + JsonOf(name) + "}\n";
}
