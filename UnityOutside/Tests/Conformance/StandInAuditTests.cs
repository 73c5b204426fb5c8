namespace UnityOutside.Tests.Conformance;

public sealed class StandInAuditTests
{
    private const string Box = "T:Unity.Things.Box\tUnity.Things\tstruct\t\tunmanaged\t\t\t\t*\n";

    [TestCase("M:Unity.Things.Box.Fill(System.Int32)\tUnity.Things\tmethod\tSystem.Void\t\tcount=4\t\t\t*", null)]
    [TestCase("M:Unity.Things.Box.Fill(System.Int32)\tUnity.Things\tmethod\tSystem.Void\t\tcount=5\t\t\t*",
        "is 5 by default, 4 here")]
    [TestCase("M:Unity.Things.Box.Fill(System.Int32)\tUnity.Things\tmethod\tSystem.Void\t\tcount\t\t\t*",
        "count is not optional in Unity")]
    [TestCase("M:Unity.Things.Box.Fill(System.Int32)\tUnity.Things\tmethod\tSystem.Void\t\tn=4\t\t\t*",
        "is called n in Unity, count here")]
    [TestCase("M:Unity.Things.Box.Fill(System.Int32)\tUnity.Things\tmethod\tSystem.Void\tstatic\tcount=4\t\t\t*",
        "is static in Unity")]
    [TestCase("M:Unity.Things.Box.Fill\tUnity.Things\tmethod\tSystem.Void\t\t\t\t\t*", "Box.Fill(System.Int32) is not Unity's")]
    public void Check_Method_IsComparedWithUnitys(string row, string reported) =>
        Expect(Audit(Box + row, box =>
        {
            var method = new MethodDefinition("Fill", MethodAttributes.Public, box.Module.TypeSystem.Void);
            method.Parameters.Add(new ParameterDefinition("count",
                ParameterAttributes.Optional | ParameterAttributes.HasDefault, box.Module.TypeSystem.Int32)
            { Constant = 4 });
            box.Methods.Add(method);
        }), reported);

    [TestCase("F:Unity.Things.Box.Limit\tUnity.Things\tconst\tSystem.Int32\t=7\t\t\t\t*", null)]
    [TestCase("F:Unity.Things.Box.Limit\tUnity.Things\tconst\tSystem.Int32\t=8\t\t\t\t*", "is 8 in Unity, 7 here")]
    [TestCase("", "F:Unity.Things.Box.Limit is not Unity's")]
    public void Check_Constant_IsComparedWithUnitys(string row, string reported) =>
        Expect(Audit(Box + row, box => box.Fields.Add(new FieldDefinition("Limit",
            FieldAttributes.Public | FieldAttributes.Static | FieldAttributes.Literal, box.Module.TypeSystem.Int32)
        { Constant = 7 })), reported);

    [Test]
    public void Check_InventedType_IsReported() => Expect(Audit("", _ => { }), "T:Unity.Things.Box is not Unity's");

    private static void Expect(IReadOnlyList<string> problems, string reported)
    {
        if (reported == null)
            Assert.That(problems, Is.Empty);
        else
            Assert.That(problems, Has.Some.Contains(reported));
    }

    private static IReadOnlyList<string> Audit(string list, System.Action<TypeDefinition> fill)
    {
        using AssemblyDefinition assembly = AssemblyDefinition.CreateAssembly(
            new AssemblyNameDefinition("Unity.Things", new System.Version(1, 0)), "Unity.Things", ModuleKind.Dll);
        ModuleDefinition module = assembly.MainModule;
        var box = new TypeDefinition("Unity.Things", "Box", TypeAttributes.Public | TypeAttributes.Sealed,
            new TypeReference("System", "ValueType", module, module.TypeSystem.CoreLibrary));
        module.Types.Add(box);
        fill(box);
        return new StandInAudit(UnityApi.Read("the list", new StringReader(list))).Check(module).ToList();
    }
}
