namespace FastPoints.Cli.Cluster;

/// <summary>A Job an array; which comes behind which is for whoever applies them, by their labels.</summary>
static class KubernetesManifest
{
    public static string Of(ClusterJob job, ClusterSettings settings)
    {
        var text = new StringBuilder($$"""
            # {{job.Name}}: {{job.Contents}}. A stage is applied when the one before is complete:
            #   for stage in {{string.Join(" ", job.Stages.Select(s => s.Name))}}; do
            #     kubectl apply -f THIS_FILE -l cloud={{job.Name}},stage=$stage || break
            #     until kubectl wait job -l cloud={{job.Name}},stage=$stage --for=condition=complete --timeout=60s; do
            #       kubectl get job -l cloud={{job.Name}},stage=$stage -o yaml | grep 'type: Failed' && break 2
            #     done
            #   done
            # Deleted and applied once more, it does what is missing: a task that is done ends at once.

            """);
        foreach (var stage in job.Stages)
            foreach (var array in stage.Arrays(settings.MaxArray))
                text.Append(Job(job, array, settings));
        return text.ToString();
    }

    static string Job(ClusterJob job, ClusterArray array, ClusterSettings settings) => $$"""
        ---
        apiVersion: batch/v1
        kind: Job
        metadata:
          name: {{job.Name}}-{{array.Name}}
          labels: {cloud: {{job.Name}}, stage: {{array.Stage.Name}}}
        spec:
          completionMode: Indexed
          completions: {{array.Tasks}}
          parallelism: {{Math.Min(array.Tasks, settings.AtOnce ?? 100)}}
          backoffLimitPerIndex: {{settings.Attempts}}
          podFailurePolicy:
            rules:
            # Bad input (3) and a bad command (2) would be so again.
            - action: FailIndex
              onExitCodes: {containerName: task, operator: In, values: [2, 3]}
            # Spot instances that end, and nodes that are drained, cost no attempt.
            - action: Ignore
              onPodConditions:
              - {type: DisruptionTarget, status: "True"}
          template:
            metadata:
              labels: {cloud: {{job.Name}}, stage: {{array.Stage.Name}}}
            spec:
              restartPolicy: Never
              terminationGracePeriodSeconds: 60
              containers:
              - name: task
                image: {{JsonOf(settings.Image!)}}
                command:
        {{Lines(Command(job, array, settings))}}        # Endpoint, region and keys of object storage, if there is such a secret.
                envFrom:
                - secretRef: {name: fastpoints, optional: true}
                resources:
                  requests:
                    cpu: {{settings.Cores}}
                    memory: {{job.NodeMebibytes}}Mi
                    ephemeral-storage: {{job.ScratchGibibytes}}Gi
                  limits: {memory: {{job.NodeMebibytes}}Mi}
                volumeMounts:
                - {name: scratch, mountPath: {{JsonOf(ScratchOf(settings))}}}
        {{VolumeMount(settings)}}      volumes:
              - name: scratch
                emptyDir: {}
        {{Volume(settings)}}
        """;

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
