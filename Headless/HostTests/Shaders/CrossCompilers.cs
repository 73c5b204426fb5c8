namespace FastPoints.HostTests.Shaders;

/// <summary>Stages as other languages have them: by spirv-cross, from the SPIR-V that glslang makes. glslang compiles ESSL 3.1;
/// naga makes WGSL, which Tint compiles. Metal has no compiler here: what spirv-cross can say in its language is taken for
/// good.</summary>
static class CrossCompilers
{
    const string Cross = "spirv-cross";
    const string Glslang = "glslangValidator";

    static string WebGpu => Path.Combine(Checkout.Repository.Root, "Headless", "artifacts", "webgpu");

    /// <summary>What is missing to run any; empty if nothing.</summary>
    internal static string Missing => string.Join(", ", new[] { Cross, Glslang }.Where(t => Tool.Find(t) == null));

    /// <summary>What is missing only for WebGPU; empty if nothing.</summary>
    internal static string MissingForWebGpu => Tool.Find("node") == null ? "node"
        : Directory.Exists(Path.Combine(WebGpu, "node_modules", "webgpu")) ? "" : "the packages of Headless/WebGpu";

    /// <summary>What is wrong with each stage in each language: nothing if it goes there. WebGPU's are null if that is
    /// not installed.</summary>
    internal static (string Metal, string Gles, string WebGpu)[] Faults(IReadOnlyList<ShaderStage> stages)
    {
        using var folder = new ScratchFolder();
        var faults = new (string Metal, string Gles, string WebGpu)[stages.Count];
        Parallel.For(0, stages.Count, Tool.OneACore, i =>
        {
            string stage = stages[i].Stage, name = folder[$"{i}.{stage}"];
            byte[] code = stages[i].Compile();
            // WGSL has no size of points.
            File.WriteAllBytes(name + ".unsized", code);
            File.WriteAllBytes(name + ".sized", stage == "vert" ? SpirvPointSize.Given(code) : code);
            faults[i] = (Then(Run(Cross, name + ".sized", "--msl", "--msl-version", "20100", "--output", name + ".metal"),
                    () => WhatMetalLacks(File.ReadAllText(name + ".metal"))),
                Then(Run(Cross, name + ".sized", "--es", "--version", "310", "--output", name + ".essl"),
                    () => Run(Glslang, "-S", stage, name + ".essl")),
                // naga wants operands of one type and buffers of SPIR-V 1.0, as glslang makes them of GLSL but not of HLSL.
                Then(Run(Cross, name + ".unsized", "-V", "--version", "450", "--output", name + ".glsl"),
                    () => Run(Glslang, "-V", "--target-env", "vulkan1.0", "-S", stage, "-o", name + ".spv", name + ".glsl")));
        });
        AddWebGpu(folder, faults);
        return faults;
    }

    static void AddWebGpu(ScratchFolder folder, (string Metal, string Gles, string WebGpu)[] faults)
    {
        if (MissingForWebGpu.Length > 0)
        {
            for (int i = 0; i < faults.Length; i++)
                faults[i].WebGpu = null;
            return;
        }
        // Beside its packages, where node looks for them.
        string script = Path.Combine(WebGpu, "check.mjs");
        File.Copy(Path.Combine(Checkout.Repository.Root, "Headless", "WebGpu", "check.mjs"), script, true);
        string[] files = Directory.GetFiles(folder.Root, "*.spv");
        (bool isGood, string said) = Tool.Run("node", files.Prepend(script).ToArray());
        string[] lines = said.Split('\n');
        if (!isGood || lines.Length != files.Length)
            throw new InvalidOperationException(said);
        foreach (string[] line in lines.Select(l => l.Split('\t')))
            faults[int.Parse(line[0].Split('.')[0])].WebGpu = line.Length > 1 ? line[1] : "";
    }

    // spirv-cross writes what Metal's compiler would refuse.
    static string WhatMetalLacks(string code) => Regex.IsMatch(code, @"\bdouble[234]?\b") ? "'double' : not in Metal" : "";

    static string Run(string program, params string[] arguments)
    {
        (bool isGood, string said) = Tool.Run(program, arguments);
        return isGood ? "" : said.Length > 0 ? said : program + " failed";
    }

    static string Then(string fault, Func<string> next) => fault.Length > 0 ? fault : next();
}
