namespace UnityOutside.Tests.Conformance;

public sealed class StandInUseTests
{
    [TestCase("Fill", null)]
    [TestCase("Empty", "M:Unity.Things.Box.Empty")]
    [TestCase("op_Addition", null)]
    public void Unnamed_MethodOfAUsedType_IsReportedUnlessNamed(string method, string reported) =>
        Expect(box => box.Methods.Add(Returning(box, method, MethodAttributes.Static)), reported);

    [Test]
    public void Unnamed_OverloadOfANamedMethod_IsNotReported() => Expect(box =>
    {
        box.Methods.Add(Returning(box, "Fill", MethodAttributes.Static));
        MethodDefinition other = Returning(box, "Fill", MethodAttributes.Static);
        other.Parameters.Add(new ParameterDefinition(box.Module.TypeSystem.Int32));
        box.Methods.Add(other);
    }, null);

    [TestCase("Overridden", null)]
    [TestCase("Ignored", "M:Unity.Things.Box.Ignored")]
    public void Unnamed_VirtualMethod_IsReportedUnlessOverridden(string method, string reported) =>
        Expect(box => box.Methods.Add(Returning(box, method, MethodAttributes.Virtual | MethodAttributes.NewSlot)), reported);

    [Test]
    public void Unnamed_ConstantOrFunctionPointer_IsNotReported() => Expect(box =>
    {
        box.Fields.Add(new FieldDefinition("Limit", FieldAttributes.Public | FieldAttributes.Static | FieldAttributes.Literal,
            box.Module.TypeSystem.Int32)
        { Constant = 7 });
        MethodDefinition fill = Returning(box, "Fill", MethodAttributes.Static);
        fill.Parameters.Add(new ParameterDefinition(new FunctionPointerType { ReturnType = box.Module.TypeSystem.Void }));
        box.Methods.Add(fill);
    }, null);

    [Test]
    public void Unnamed_StaticField_IsReported() => Expect(box => box.Fields.Add(new FieldDefinition("Loose",
        FieldAttributes.Public | FieldAttributes.Static, box.Module.TypeSystem.Int32)), "F:Unity.Things.Box.Loose");

    [Test]
    public void Unnamed_TypeThatOnlyItselfNames_IsReported() => Expect(box =>
    {
        var lone = new TypeDefinition("Unity.Things", "Lone", TypeAttributes.Public, box.Module.TypeSystem.Object);
        lone.Fields.Add(new FieldDefinition("Next", FieldAttributes.Public, lone));
        box.Module.Types.Add(lone);
    }, "T:Unity.Things.Lone");

    private static MethodDefinition Returning(TypeDefinition box, string name, MethodAttributes attributes)
    {
        var method = new MethodDefinition(name, MethodAttributes.Public | attributes, box.Module.TypeSystem.Void);
        method.Body.GetILProcessor().Emit(OpCodes.Ret);
        return method;
    }

    private static void Expect(Action<TypeDefinition> fill, string reported)
    {
        using AssemblyDefinition standIn = Assembly("Unity.Things");
        using AssemblyDefinition user = Assembly("User");
        var box = new TypeDefinition("Unity.Things", "Box", TypeAttributes.Public, standIn.MainModule.TypeSystem.Object);
        standIn.MainModule.Types.Add(box);
        fill(box);
        var caller = new TypeDefinition("", "Caller", TypeAttributes.Public, user.MainModule.ImportReference(box));
        caller.Methods.Add(new MethodDefinition("Overridden", MethodAttributes.Public | MethodAttributes.Virtual,
            user.MainModule.TypeSystem.Void));
        var main = new MethodDefinition("Main", MethodAttributes.Static, user.MainModule.TypeSystem.Void);
        var named = new MethodReference("Fill", user.MainModule.TypeSystem.Void, user.MainModule.ImportReference(box));
        main.Body.GetILProcessor().Emit(OpCodes.Call, named);
        caller.Methods.Add(main);
        user.MainModule.Types.Add(caller);

        var use = new StandInUse();
        use.Count(user.MainModule);
        use.Count(standIn.MainModule);

        Assert.That(use.Unnamed(standIn.MainModule), Is.EqualTo(new[] { reported }.Where(r => r != null)));
    }

    private static AssemblyDefinition Assembly(string name) =>
        AssemblyDefinition.CreateAssembly(new AssemblyNameDefinition(name, new Version(1, 0)), name, ModuleKind.Dll);
}
