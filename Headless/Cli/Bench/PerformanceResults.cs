namespace FastPoints.Cli.Bench;

public static class PerformanceResults
{
    public const string FileName = "PerformanceTestResults.json";

    /// <summary>The test that times a workload in Unity: results of both have one name.</summary>
    const string TestClass = "FastPoints.Benchmarks.WorkloadTests", TestMethod = "Run";

    static readonly JsonSerializerOptions s_options = new()
    {
        IncludeFields = true,
        WriteIndented = true,
        Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping,
    };

    public static PerformanceRun Of(IEnumerable<WorkloadSamples> samples) => new()
    {
        TestSuite = "Headless",
        Date = DateTimeOffset.UtcNow.ToUnixTimeMilliseconds(),
        Player = new RunPlayer
        {
            Batchmode = true,
            Platform = RuntimeInformation.RuntimeIdentifier,
            ScriptingBackend = "CoreCLR",
            RenderThreadingMode = "SingleThreaded",
        },
        Hardware = new RunHardware
        {
            OperatingSystem = RuntimeInformation.OSDescription.Trim(),
            DeviceModel = RuntimeInformation.ProcessArchitecture.ToString(),
            DeviceName = Threads.InUse + " threads in use",
            ProcessorType = Machine.Processor(),
            ProcessorCount = Environment.ProcessorCount,
            SystemMemorySizeMB = (int)Math.Min(int.MaxValue, GC.GetGCMemoryInfo().TotalAvailableMemoryBytes / (1 << 20)),
        },
        Editor = new RunEditor { Version = RuntimeInformation.FrameworkDescription },
        Dependencies = ["com.fastpoints.dots@" + typeof(PerformanceResults).Assembly.GetName().Version!.ToString(3)],
        Results = samples.Where(s => s.HadInput).Select(Result).ToList(),
    };

    public static byte[] ToBytes(PerformanceRun run) => JsonSerializer.SerializeToUtf8Bytes(run, s_options);

    public static string? WorkloadOf(PerformanceTestResult result)
    {
        string begin = TestClass + "." + TestMethod + "(\"";
        return result.Name.StartsWith(begin, StringComparison.Ordinal) &&
            result.Name.EndsWith("\")", StringComparison.Ordinal)
            ? result.Name[begin.Length..^2] : null;
    }

    static PerformanceTestResult Result(WorkloadSamples samples) => new()
    {
        Name = TestClass + "." + TestMethod + "(\"" + samples.Name + "\")",
        ClassName = TestClass,
        MethodName = TestMethod,
        SampleGroups = samples.Series().Where(s => s.Samples.Count > 0).Select(Group).ToList(),
    };

    static SampleGroup Group(SampleSeries series)
    {
        double average = series.Samples.Average();
        return new SampleGroup
        {
            Name = series.Name,
            Unit = (int)series.Unit,
            IncreaseIsBetter = series.IncreaseIsBetter,
            Samples = series.Samples.ToList(),
            Min = series.Samples.Min(),
            Max = series.Samples.Max(),
            Median = WorkloadSamples.Median(series.Samples),
            Average = average,
            StandardDeviation = Math.Sqrt(series.Samples.Average(s => (s - average) * (s - average))),
            Sum = series.Samples.Sum(),
        };
    }

    public static PerformanceRun Read(string path)
    {
        try
        {
            byte[] bytes = File.ReadAllBytes(path);
            using var document = JsonDocument.Parse(bytes);
            if (document.RootElement.TryGetProperty("workloads", out var workloads))
                return new PerformanceRun { Results = workloads.EnumerateArray().Select(FromSummary).ToList() };
            if (document.RootElement.TryGetProperty("Results", out _))
                return JsonSerializer.Deserialize<PerformanceRun>(bytes, s_options)!;
        }
        catch (Exception e) when (e is FileNotFoundException or DirectoryNotFoundException)
        {
            throw new PointCloudException(FailureCode.NotFound, path, -1, "no such file", e);
        }
        catch (Exception e) when (e is JsonException or KeyNotFoundException or InvalidOperationException)
        {
            throw NoRun(path, e);
        }
        throw NoRun(path, null);
    }

    static PerformanceTestResult FromSummary(JsonElement workload)
    {
        var samples = new WorkloadSamples(workload.GetProperty("name").GetString()!, null);
        double ms = workload.GetProperty("ms").GetDouble();
        samples.Add(ms, 0, new WorkloadResult
        {
            Points = (long)Math.Round(ms * workload.GetProperty("pointsPerSecond").GetDouble() / 1000),
            Bytes = (long)Math.Round(ms * workload.GetProperty("bytesPerSecond").GetDouble() / 1000),
        });
        return Result(samples);
    }

    static PointCloudException NoRun(string path, Exception? inner) => new(FailureCode.BadInput, path, -1,
        "is neither a " + FileName + " nor the --json summary of a bench run", inner);
}
