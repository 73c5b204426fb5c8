using System.Security.Cryptography;

namespace StandIns.Graphics;

/// <summary>HLSL to SPIR-V by glslang, a process of some 50 ms each; what was compiled once is kept on disk under a hash of all
/// that went in.</summary>
static class ShaderCompiler
{
    const string Program = "glslangValidator";
    const string Target = "vulkan1.1"; // 1.3 as the target is broken for HLSL in glslang 12.
    // What Unity defines for Vulkan on a desktop, and one name to tell this compiler.
    const string Platform = "#define SHADER_API_VULKAN 1\n#define SHADER_API_DESKTOP 1\n#define UNITY_REVERSED_Z 1\n"
        + "#define UNITY_UV_STARTS_AT_TOP 1\n#define UNITY_NEAR_CLIP_VALUE 1.0\n#define UNITY_RAW_FAR_CLIP_VALUE 0.0\n"
        + "#define SHADER_TARGET 50\n#define FASTPOINTS_GLSLANG 1\n";

    static string s_version;
    internal static int Runs { get; private set; }
    internal static bool IsThere => Version().Length > 0;

    internal static byte[] Compile(ShaderFiles files, string name, string source, string stage, string entry,
        IEnumerable<string> keywords)
    {
        var text = new StringBuilder(Platform);
        text.Append("#define SHADER_STAGE_").Append(StageName(stage)).Append(" 1\n");
        foreach (string keyword in keywords)
            text.Append("#define ").Append(keyword).Append(" 1\n");
        text.Append("#line 1\n").Append(source);
        string key = Hash(files, text.ToString(), Flags(stage) + stage + " " + entry);
        string output = Path.Combine(CacheFolder(files), key + ".spv");
        if (!File.Exists(output))
            Run(files, name, text.ToString(), stage, entry, output);
        return File.ReadAllBytes(output);
    }

    // With the names of semantics in vertex shaders: SpirvPointSize looks for one.
    static string Flags(string stage) => $"-D -V --target-env {Target} --auto-map-bindings --hlsl-offsets"
        + (stage == "vert" ? " -fhlsl_functionality1" : "");

    static string StageName(string stage) => stage == "vert" ? "VERTEX" : stage == "frag" ? "FRAGMENT" : "COMPUTE";

    static void Run(ShaderFiles files, string name, string text, string stage, string entry, string output)
    {
        if (!IsThere)
            throw new InvalidOperationException($"{name}: there is no {Program} to compile it (Debian, Ubuntu: apt-get "
                + $"install "
                + "glslang-tools)");
        Directory.CreateDirectory(Path.GetDirectoryName(output));
        // Files of its own, then one rename: others may compile the same at the same time.
        string own = output + "." + Process.GetCurrentProcess().Id + "." + Environment.CurrentManagedThreadId;
        File.WriteAllText(own + ".hlsl", text);
        var arguments = new StringBuilder($"{Flags(stage)} -S {stage} -e {entry}");
        foreach (string folder in files.Folders)
            arguments.Append(" \"-I").Append(folder).Append('"');
        arguments.Append($" -o \"{own}.spv\" \"{own}.hlsl\"");
        (int status, string said) = Start(arguments.ToString());
        File.Delete(own + ".hlsl");
        Runs++;
        if (status != 0 || !File.Exists(own + ".spv"))
            throw new InvalidOperationException($"{name} ({entry}): {said.Replace(own + ".hlsl", name).Trim()}");
        if (File.Exists(output))
            File.Delete(own + ".spv");
        else
            File.Move(own + ".spv", output);
    }

    static (int Status, string Said) Start(string arguments)
    {
        var start = new ProcessStartInfo(Program, arguments) { RedirectStandardOutput = true, UseShellExecute = false };
        using Process process = Process.Start(start);
        string said = process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        return (process.ExitCode, said);
    }

    static string Version()
    {
        if (s_version == null)
            try
            {
                s_version = Start("--version").Said;
            }
            catch (System.ComponentModel.Win32Exception)
            {
                s_version = "";
            }
        return s_version;
    }

    static string Hash(ShaderFiles files, string text, string target)
    {
        var all = new StringBuilder(target).Append('\n').Append(text);
        foreach (string file in files.Includes(text).OrderBy(f => f, StringComparer.Ordinal))
            all.Append('\n').Append(file).Append('\n').Append(File.ReadAllText(file));
        using SHA256 sha = SHA256.Create();
        byte[] hash = sha.ComputeHash(Encoding.UTF8.GetBytes(all.ToString()));
        return BitConverter.ToString(hash, 0, 16).Replace("-", "").ToLowerInvariant();
    }

    static string CacheFolder(ShaderFiles files)
    {
        string headless = Path.Combine(files.Root, "Headless");
        return Directory.Exists(headless)
            ? Path.Combine(headless, "artifacts", "shaders")
            : Path.Combine(Environment.GetFolderPath(Environment.SpecialFolder.LocalApplicationData), "fastpoints", "shaders");
    }
}
