namespace FastPoints.Cli.Output;

public static class Machine
{
    public static string Describe() => Processor() + ", " + Environment.ProcessorCount
        + (Environment.ProcessorCount == 1 ? " core" : " cores") + " (" + Threads.InUse + " in use); "
        + RuntimeInformation.OSDescription.Trim() + ", "
        + RuntimeInformation.ProcessArchitecture + "; " + RuntimeInformation.FrameworkDescription;

    public static string Processor()
    {
        const string CpuInfo = "/proc/cpuinfo";
        try
        {
            if (File.Exists(CpuInfo) && File.ReadLines(CpuInfo).FirstOrDefault(l => l.StartsWith("model name")) is { } line)
                return line[(line.IndexOf(':') + 1)..].Trim();
        }
        catch (IOException)
        {
            // The environment variable below names it.
        }
        return Environment.GetEnvironmentVariable("PROCESSOR_IDENTIFIER") ?? "unnamed processor";
    }
}
