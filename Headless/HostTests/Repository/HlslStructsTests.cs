using FastPoints.RepoTools.Hlsl;

namespace FastPoints.HostTests.Repository;

public sealed class HlslStructsTests
{
    [Test]
    public void Compose_VectorsEnumAndFixedArray_HaveOffsetsAndSizes()
    {
        using ModuleDefinition module = OwnModule();
        string text = HlslStructs.Compose(module.GetType(typeof(PlantedRecord).FullName));

        Assert.That(text, Is.EqualTo(
            "// Written by RepoTools hlsl from FastPoints.HostTests.Repository.PlantedRecord: 40 bytes.\n" +
            "#ifndef FASTPOINTS_PLANTED_RECORD_INCLUDED\n#define FASTPOINTS_PLANTED_RECORD_INCLUDED\n\n" +
            "#include \"../PointLists.hlsl\"\n\n" +
            "struct PlantedRecord\n{\n" +
            "    float3 Corner;   // 0, 12\n" +
            "    uint FirstPoint; // 12, 4\n" +
            "    int2 Size;       // 16, 8\n" +
            "    uint Shape;      // 24, 4\n" +
            "    uint Widths[3];  // 28, 12\n" +
            "};\n\n" +
            "// at: where it begins in the lists, in bytes.\n" +
            "PlantedRecord FastPointsPlantedRecordAt(uint at)\n{\n" +
            "    PlantedRecord loaded;\n" +
            "    loaded.Corner = asfloat(_FastPointsLists.Load3(at + 0u));\n" +
            "    loaded.FirstPoint = _FastPointsLists.Load(at + 12u);\n" +
            "    loaded.Size = asint(_FastPointsLists.Load2(at + 16u));\n" +
            "    loaded.Shape = _FastPointsLists.Load(at + 24u);\n" +
            "    loaded.Widths[0] = _FastPointsLists.Load(at + 28u);\n" +
            "    loaded.Widths[1] = _FastPointsLists.Load(at + 32u);\n" +
            "    loaded.Widths[2] = _FastPointsLists.Load(at + 36u);\n" +
            "    return loaded;\n}\n\n#endif\n"));
    }

    [TestCase(typeof(PlantedWithByte), "Width: no System.Byte in HLSL")]
    [TestCase(typeof(PlantedWithGap), "Width is at 8, HLSL would have it at 4")]
    public void Compose_LayoutDiffersInHlsl_IsRefused(System.Type type, string reason)
    {
        using ModuleDefinition module = OwnModule();

        Assert.That(() => HlslStructs.Compose(module.GetType(type.FullName)),
            Throws.TypeOf<ToolException>().With.Message.Contains(reason));
    }

    [Test]
    public void Run_StructChangedAndFileLeftOver_CheckReportsBothAndRunMendsThem()
    {
        using ModuleDefinition module = OwnModule();
        DirectoryInfo folder = Directory.CreateTempSubdirectory("fastpoints-hlsl-");
        try
        {
            File.WriteAllText(Path.Combine(folder.FullName, "PlantedRecord.hlsl"), "struct PlantedRecord { uint Old; };\n");
            File.WriteAllText(Path.Combine(folder.FullName, "Gone.hlsl"), "");

            Assert.That(HlslCommand.Run(new[] { module }, folder.FullName, true).Problems, Has.Count.EqualTo(2));
            HlslCommand.Run(new[] { module }, folder.FullName, false);
            Assert.That(HlslCommand.Run(new[] { module }, folder.FullName, true).Problems, Is.Empty);
            Assert.That(folder.GetFiles(), Has.Length.EqualTo(1));
        }
        finally
        {
            folder.Delete(true);
        }
    }

    private static ModuleDefinition OwnModule()
    {
        var resolver = new DefaultAssemblyResolver();
        resolver.AddSearchDirectory(Path.GetDirectoryName(typeof(HlslStructsTests).Assembly.Location));
        return ModuleDefinition.ReadModule(typeof(HlslStructsTests).Assembly.Location,
            new ReaderParameters { AssemblyResolver = resolver });
    }
}
