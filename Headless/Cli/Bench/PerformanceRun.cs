// The classes are the Performance Testing package's own JSON (Unity.PerformanceTesting.Data.Run, version 3), field by
// field: readers of its PerformanceTestResults.json read our runs.
namespace FastPoints.Cli.Bench;

public sealed class PerformanceRun
{
    public string TestSuite = "";

    /// <summary>Milliseconds since 1970, UTC.</summary>
    public long Date;
    public RunPlayer Player = new();
    public RunHardware Hardware = new();
    public RunEditor Editor = new();
    public List<string> Dependencies = [];
    public List<PerformanceTestResult> Results = [];
}

public sealed class PerformanceTestResult
{
    public string Name = "";
    public string ClassName = "";
    public string MethodName = "";
    public string Version = "1";
    public List<string> Categories = ["Performance"];
    public List<SampleGroup> SampleGroups = [];
    public double Threshold = -1;
}

public sealed class SampleGroup
{
    public string Name = "";

    /// <summary>2 milliseconds, 4 bytes, 8 undefined; the others as in the package.</summary>
    public int Unit;
    public bool IncreaseIsBetter;
    public List<double> Samples = [];
    public double Min;
    public double Max;
    public double Median;
    public double Average;
    public double StandardDeviation;
    public double Sum;
}

/// <summary>What is not known without a player is empty or 0.</summary>
public sealed class RunPlayer
{
    public bool Development;
    public int ScreenWidth;
    public int ScreenHeight;
    public int ScreenRefreshRate;
    public bool Fullscreen;
    public int Vsync;
    public int AntiAliasing;
    public bool Batchmode;
    public string RenderThreadingMode = "";
    public bool MtRendering;
    public bool GraphicsJobs;
    public bool GpuSkinning;
    public string Platform = "";
    public string ColorSpace = "";
    public string AnisotropicFiltering = "";
    public string BlendWeights = "";
    public string GraphicsApi = "";
    public string ScriptingBackend = "";
    public string AndroidTargetSdkVersion = "";
    public string AndroidBuildSystem = "";
    public string BuildTarget = "";
    public string StereoRenderingPath = "";
}

public sealed class RunHardware
{
    public string OperatingSystem = "";
    public string DeviceModel = "";
    public string DeviceName = "";
    public string ProcessorType = "";
    public int ProcessorCount;
    public string GraphicsDeviceName = "";
    public int SystemMemorySizeMB;
}

public sealed class RunEditor
{
    public string Version = "";
    public string Branch = "";
    public string Changeset = "";
    public int Date;
}
