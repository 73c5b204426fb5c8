namespace FastPoints.HostTests.Shaders;

/// <summary>Direct3D's own compiler, d3dcompiler_47.dll, under Wine. Unity takes it for Direct3D 11 and 12, and for Metal, OpenGL
/// and Vulkan, whose code it makes of the bytecode. One process compiles all, since Wine takes seconds to start.</summary>
static class Direct3DCompiler
{
    // The profile of #pragma target 4.5 and above.
    const string Profiles = "_5_0";
    const string Builder = "x86_64-w64-mingw32-gcc";

    // What Unity's own preprocessor takes out: the compiler would warn that it does not know them.
    static readonly Regex s_pragma = new(@"^[ \t]*#[ \t]*pragma[ \t]+"
        + @"(vertex|fragment|kernel|target|require|multi_compile\w*|shader_feature\w*)\b.*$", RegexOptions.Multiline);

    static string Folder => Path.Combine(Checkout.Repository.Root, "Headless", "artifacts", "direct3d");
    static string Project => Path.Combine(Checkout.Repository.Root, "Headless", "Direct3D");
    static string Wine => Tool.Find("wine64", "/usr/lib/wine");

    // NuGet's folder, as Direct3D.csproj fills it.
    static string Library
    {
        get
        {
            string packages = Environment.GetEnvironmentVariable("NUGET_PACKAGES")
                ?? Path.Combine(Environment.GetFolderPath(Environment.SpecialFolder.UserProfile), ".nuget", "packages");
            string project = File.ReadAllText(Path.Combine(Project, "Direct3D.csproj"));
            string version = Regex.Match(project, @"Version=""\[(.+)\]""").Groups[1].Value;
            return Path.Combine(packages, "microsoft.windows.sdk.cpp", version, "c/Redist/D3D/x64/d3dcompiler_47.dll");
        }
    }

    /// <summary>What is missing to run it; empty if nothing.</summary>
    internal static string Missing => string.Join(", ", new[]
    {
        Wine == null ? "wine64" : "", Tool.Find(Builder) == null ? Builder : "", File.Exists(Library) ? "" : Library,
    }.Where(m => m.Length > 0));

    /// <summary>Compiles stages, each with flags of its own (D3DCOMPILE_..).</summary>
    internal static string[] Compile(IReadOnlyList<(ShaderStage Stage, uint Flags)> all)
    {
        using var folder = new ScratchFolder();
        var list = new StringBuilder();
        for (int i = 0; i < all.Count; i++)
        {
            File.WriteAllText(folder[i + ".hlsl"], Text(all[i].Stage));
            list.Append($"{i}.hlsl\t{all[i].Stage.Entry}\t{Profile(all[i].Stage)}\t{all[i].Flags:x}\n");
        }
        File.WriteAllText(folder["list"], list.ToString());
        Run(folder);
        string[] said = File.ReadAllText(folder["results"]).Replace("\r", "").Replace("\0", "").Split("\n> ")
            .Select(s => s.TrimStart('>', ' ')).ToArray();
        if (said.Length != all.Count)
            throw new InvalidOperationException($"{said.Length} of {all.Count} were compiled");
        return said.Select(s => Regex.Replace(s, "^ok", "").Trim()).ToArray();
    }

    static string Profile(ShaderStage stage) => (stage.Stage == "vert" ? "vs" : stage.Stage == "frag" ? "ps" : "cs") + Profiles;

    static string Text(ShaderStage stage)
    {
        // No more of Unity's names: a test ensures that the package's shaders use none.
        var text = new StringBuilder("#define SHADER_API_D3D11 1\n#define SHADER_API_DESKTOP 1\n#define SHADER_TARGET 45\n");
        text.Append("#define SHADER_STAGE_")
            .Append(stage.Stage == "vert" ? "VERTEX" : stage.Stage == "frag" ? "FRAGMENT" : "COMPUTE").Append(" 1\n");
        foreach (string keyword in stage.Keywords)
            text.Append("#define ").Append(keyword).Append(" 1\n");
        text.Append($"#line 1 \"{stage.Name}\"\n");
        return text.Append(stage.Files.Flat(s_pragma.Replace(stage.Source, ""), stage.Name)).ToString();
    }

    static void Run(ScratchFolder folder)
    {
        Directory.CreateDirectory(Folder);
        string host = Path.Combine(Folder, "CompileShaders.exe");
        string source = Path.Combine(Project, "CompileShaders.c");
        (bool isGood, string said) = Tool.Run(Builder, "-O1", "-Wall", "-Wextra", "-Werror", "-o", host, source);
        if (!isGood)
            throw new InvalidOperationException(said);
        // By another name: Wine has a compiler of its own by this one.
        string library = Path.Combine(Folder, "microsoft_d3dcompiler.dll");
        File.Copy(Library, library, true);
        // Wine's servers live on for seconds: with pipes of ours this would wait for them.
        var start = new ProcessStartInfo("/bin/sh", new[]
        {
            "-c", "exec \"$0\" \"$@\" </dev/null >log 2>&1", Wine, host, "Z:" + library.Replace('/', '\\'), "list", "results",
        })
        { WorkingDirectory = folder.Root };
        start.Environment["WINEPREFIX"] = Path.Combine(Folder, "wine");
        start.Environment["WINEDEBUG"] = "-all";
        // Neither .NET nor a browser is wanted in Wine's new folder, nor a display.
        start.Environment["WINEDLLOVERRIDES"] = "mscoree,mshtml=";
        start.Environment.Remove("DISPLAY");
        using Process process = Process.Start(start);
        process.WaitForExit();
        if (process.ExitCode != 0)
            throw new InvalidOperationException($"Wine ended with {process.ExitCode}: {File.ReadAllText(folder["log"])}");
    }
}
