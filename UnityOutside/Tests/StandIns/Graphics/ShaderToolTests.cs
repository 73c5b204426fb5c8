using Silk.NET.Vulkan;

namespace UnityOutside.Tests.StandIns.Graphics;

public sealed class ShaderToolTests
{
    private const string Pass = "HLSLPROGRAM\n#pragma vertex V\n#pragma fragment F\n"
        + "float4 V(uint id : SV_VertexID) : SV_Position { return id; }\nfloat4 F() : SV_Target { return 1; }\nENDHLSL";

    private DirectoryInfo m_folder;

    [SetUp]
    public void MakeFolder() => m_folder = Directory.CreateTempSubdirectory("shader-tools-");

    [TearDown]
    public void RemoveFolder() => m_folder.Delete(true);

    private static void RequireCompiler()
    {
        if (!ShaderCompiler.IsThere)
            Assert.Ignore("glslangValidator is not installed (Debian, Ubuntu: apt-get install glslang-tools)");
    }

    private string Write(string name, string text)
    {
        string path = Path.Combine(m_folder.FullName, name);
        File.WriteAllText(path, text);
        return path;
    }

    private ShaderLabSource Read(string body) => ShaderLabReader.Read(Write("a.shader", "Shader \"A\" {\n" + body + "\n}"));

    [TestCase("SubShader { Pass { Cull Sideways " + Pass + " } }", "a.shader(2): 'Sideways' is none of Off, Front, Back")]
    [TestCase("SubShader { Pass { Stencil { Ref 1 } " + Pass + " } }", "'Stencil' is not known in a Pass")]
    [TestCase("SubShader { Pass { Cull Off } }", "a Pass without a program")]
    [TestCase("SubShader { }", "no SubShader with a Pass")]
    [TestCase("SubShader { Pass { " + Pass, "the file ends within a block")]
    [TestCase("Properties { _A (\"A\", Float) 1 } SubShader { Pass { " + Pass + " } }", "'=' is wanted, '1' is there")]
    [TestCase("SubShader { Pass { HLSLPROGRAM\n#pragma vertex V\nENDHLSL } }", "#pragma fragment")]
    public void Read_UnknownSyntax_IsRefusedWithItsLine(string body, string message) =>
        Assert.That(() => Read(body), Throws.InstanceOf<InvalidDataException>().With.Message.Contains(message));

    [Test]
    public void Read_PropertiesStateAndPasses_AreParsed()
    {
        ShaderLabSource shader =
            Read("SubShader { PackageRequirements { \"com.unity.other\" } Pass { " + Pass + " } }\n"
            + "Properties { [Header(A)] _A (\"A\", Range(0, 1)) = 0.5 _B (\"B\", Vector) = (1, 2, 3, -4)\n"
            + "_C (\"C\", Integer) = 7 } // comment {\n"
            + "/* Pass { */ SubShader { Cull Off Pass { Name \"ONE\" " + Pass
                + " } Pass { Tags { \"LightMode\" = \"X\" } Cull Front "
            + Pass + " } }\nSubShader { Pass { " + Pass + " } } CustomEditor \"Some.Editor\" Fallback Off");
        Assert.That((shader.Name, shader.Passes.Count, shader.Passes[0].Name), Is.EqualTo(("A", 2, "ONE")));
        var scope = new PropertyScope(null, shader.Defaults);
        Assert.That(shader.Passes[0].State.Evaluate(scope).Cull, Is.EqualTo(CullModeFlags.None));
        Assert.That(shader.Passes[1].State.Evaluate(scope).Cull, Is.EqualTo(CullModeFlags.FrontBit));
        Assert.That(shader.Passes[1].Tags["LightMode"], Is.EqualTo("X"));
        shader.Defaults.TryGet(PropertyNames.IdOf("_B"), out PropertyValue vector);
        Assert.That(vector.Vector, Is.EqualTo(new Vector4(1, 2, 3, -4)));
    }

    [Test]
    public void Keywords_EachLineIsOneChoice()
    {
        KeywordGroup[] groups =
        {
            KeywordGroup.TryRead(new[] { "multi_compile", "_", "A", "B" }),
            KeywordGroup.TryRead(new[] { "multi_compile_local_fragment", "C", "D" }),
            KeywordGroup.TryRead(new[] { "shader_feature", "E" }),
        };
        var local = new KeywordSet();
        local.Set("B", true);
        local.Set("E", true);
        Assert.That(KeywordVariant.Count(groups), Is.EqualTo(12));
        long variant = KeywordVariant.Choose(groups, local);
        Assert.That(KeywordVariant.Names(groups, variant, "frag"), Is.EqualTo(new[] { "B", "C", "E" }));
        Assert.That(KeywordVariant.Names(groups, variant, "vert"), Is.EqualTo(new[] { "B", "E" }));
        Assert.That(KeywordGroup.TryRead(new[] { "target", "4.5" }), Is.Null);
    }

    [Test]
    public void Keywords_Stereo_IsAvailableOnRequest()
    {
        Write("eyes.hlsl", "#if defined(STEREO_INSTANCING_ON)\n#endif\n");
        string stereo = Pass.Replace("ENDHLSL", "#include \"eyes.hlsl\"\nENDHLSL");
        ShaderLabSource shader = Read("SubShader { Pass { " + Pass + " } Pass { " + stereo + " } }");
        Assert.That(shader.Passes.Select(p => KeywordVariant.Count(p.Keywords)), Is.EqualTo(new[] { 1, 2 }));
    }

    [Test]
    public void Compile_Error_NamesTheFileAndItsLine()
    {
        RequireCompiler();
        ShaderLabSource shader = Read("SubShader { Pass {\n" + Pass.Replace("return 1;", "return nothing;") + "\n} }");
        Assert.That(() =>
            shader.Passes[0].Fragment(0).Compile(), Throws.InvalidOperationException.With.Message.Contains(":7: 'nothing'"));
    }

    [Test]
    public void Compile_Again_RunsNoCompilerUntilAnIncludeChanges()
    {
        RequireCompiler();
        Write("inner.hlsl", "#define VALUE 1u // " + Guid.NewGuid());
        Write("outer.hlsl", "#include \"inner.hlsl\"\n");
        string path = Write("a.compute", "#pragma kernel K\n#include \"outer.hlsl\"\nRWStructuredBuffer<uint> _A;\n"
            + "[numthreads(1,1,1)] void K() { _A[0] = VALUE; }\n");
        byte[] Compile() => new ComputeSource(path).Kernel("K", 0).Compile();
        int runs = ShaderCompiler.Runs;
        byte[] first = Compile();
        Assert.That(Compile(), Is.EqualTo(first));
        Assert.That(ShaderCompiler.Runs - runs, Is.EqualTo(1));
        Write("inner.hlsl", "#define VALUE 2u // " + Guid.NewGuid());
        Assert.That(Compile(), Is.Not.EqualTo(first));
        Assert.That(ShaderCompiler.Runs - runs, Is.EqualTo(2));
    }

    [Test]
    public void Reflection_Resources_AreThoseOfTheSource()
    {
        RequireCompiler();
        var source = new ComputeSource(Write("a.compute", "#pragma kernel K\nstruct E { float4 A; uint4 B; };\n"
            + "StructuredBuffer<E> _In : register(t0);\nRWByteAddressBuffer _Out : register(u0);\nTexture2DArray<float> "
                + "_Slices;\n"
            + "cbuffer Given { float3 _V; float _F; float4 _Many[3]; };\nfloat4x4 _M; int2 _I;\n"
            + "[numthreads(4,2,1)] void K(uint3 id : SV_DispatchThreadID) { E e = _In[id.x]; float4 v = mul(_M, e.A) + _V.x "
                + "* _F;\n"
            + "_Out.Store(4, asuint(v.x + _Many[id.y].x + _Slices.Load(int4(_I, 0, 0)))); }\n"));
        var module = new SpirvModule(source.Kernel("K", 0).Compile());
        Dictionary<string, ShaderResource> resources = module.Resources().ToDictionary(r => r.Name);
        Assert.That((resources["_In"].Kind, resources["_In"].Stride, resources["_In"].IsWritten),
            Is.EqualTo((DescriptorType.StorageBuffer, 32, false)));
        Assert.That((resources["_Out"].Stride, resources["_Out"].IsWritten), Is.EqualTo((4, true)));
        Assert.That(resources["_Slices"].IsArray, Is.True);
        Assert.That(resources["Given"].Members.Select(m => (m.Name, m.Offset, m.Count, m.End)),
            Is.EqualTo(new[] { ("_V", 0, 1, 12), ("_F", 12, 1, 16), ("_Many", 16, 3, 64) }));
        Assert.That(resources["$Global"].Members.Select(m => (m.Name, m.IsFloat, m.Columns, m.Rows)),
            Is.EqualTo(new[] { ("_M", true, 4, 4), ("_I", false, 1, 2) }));
    }
}
