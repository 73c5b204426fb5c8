namespace FastPoints.HostTests.Shaders;

static class Tool
{
    /// <summary>A thread that waits for a program makes the pool start another, until hundreds run at once.</summary>
    internal static ParallelOptions OneACore => new() { MaxDegreeOfParallelism = Environment.ProcessorCount };

    /// <summary>Where a program lies: on the PATH, or in one of the folders; null if it does not.</summary>
    internal static string Find(string name, params string[] folders) =>
        (Environment.GetEnvironmentVariable("PATH") ?? "").Split(Path.PathSeparator).Concat(folders)
            .Where(folder => folder.Length > 0).Select(folder => Path.Combine(folder, name)).FirstOrDefault(File.Exists);

    internal static (bool Succeeded, string Output) Run(string program, params string[] arguments)
    {
        var start = new ProcessStartInfo(program, arguments) { RedirectStandardOutput = true, RedirectStandardError = true };
        using Process process = Process.Start(start);
        var errors = process.StandardError.ReadToEndAsync();
        string said = process.StandardOutput.ReadToEnd() + errors.Result;
        process.WaitForExit();
        return (process.ExitCode == 0, said.Trim());
    }
}
