namespace FastPoints.Cli.Output;

public static class PeakMemory
{
    public static long ResidentBytes
    {
        get
        {
            const string status = "/proc/self/status";
            if (OperatingSystem.IsLinux() && File.Exists(status))
                foreach (string line in File.ReadLines(status))
                    if (line.StartsWith("VmHWM:", StringComparison.Ordinal))
                        return 1024 * long.Parse(line.AsSpan(6, line.Length - 6 - 2), NumberStyles.AllowLeadingWhite
                            | NumberStyles.AllowTrailingWhite, CultureInfo.InvariantCulture);
            using var self = Process.GetCurrentProcess();
            return self.PeakWorkingSet64;
        }
    }
}
