namespace UnityOutside.Tests.Conformance;

public sealed class ConformanceTests
{
    private PlantedPackage m_package;
    private TypeReference m_int;
    private TypeReference m_void;

    [SetUp]
    public void MakePackage()
    {
        m_package = new PlantedPackage();
        m_int = m_package.Module.TypeSystem.Int32;
        m_void = m_package.Module.TypeSystem.Void;
    }

    [TearDown]
    public void Close() => m_package.Dispose();

    [Test]
    public void Check_MatchesUnity_NoProblem()
    {
        GenericInstanceType box = m_package.Box(m_int);
        GenericParameter element = box.ElementType.GenericParameters[0];
        m_package.Emit(OpCodes.Newobj, m_package.Method(box, ".ctor", m_void, false, m_int));
        m_package.Emit(OpCodes.Call, m_package.Method(box, "Get", element, false, m_int));
        m_package.Emit(OpCodes.Call, m_package.Method(box, "get_Length", m_int, false));
        m_package.Emit(OpCodes.Call, m_package.Method(box, "get_Item", new ByReferenceType(element), false, m_int));
        m_package.Emit(OpCodes.Ldsfld, new FieldReference("Limit", m_int, box));
        TypeDefinition job = m_package.Add("Job", true, null, m_package.Type("IRun", false));
        PlantedPackage.Define(job, "Run", MethodAttributes.Virtual | MethodAttributes.NewSlot, m_int);
        Schedule(job);
        TypeDefinition runner = m_package.Add("Runner", false, m_package.Type("Runner", false));
        PlantedPackage.Define(runner, "Start", MethodAttributes.Virtual);
        Mark("Level");

        Assert.That(m_package.Check("6000.5"), Is.Empty);
    }

    [Test]
    public void Check_InventedType_IsReported()
    {
        m_package.User.Fields.Add(new FieldDefinition("A", FieldAttributes.Public, m_package.Type("Sphere", true)));

        Reports("Unity.Things.Sphere is not in the list (named in FastPoints.Planted.User.A)");
    }

    [Test]
    public void Check_InventedMethod_IsReported()
    {
        Call("Grow", m_void, false);

        Reports("Unity.Things.Box`1.Grow is not in the list (named in FastPoints.Planted.User.Use)");
    }

    [TestCase("NUnit.Framework", "Assert", "Multiple", "NUnit.Framework.Assert.Multiple is not in Unity's NUnit")]
    [TestCase("NUnit.Framework", "Warn", "Unless", "NUnit.Framework.Warn is not in Unity's NUnit")]
    [TestCase("NUnit.Framework.Constraints", "EqualConstraint", "ApplyTo", "EqualConstraint.ApplyTo is not in Unity's NUnit")]
    [TestCase("NUnit.Framework.Internal", "TestResult", "get_Output", "Internal.TestResult is not in Unity's NUnit")]
    [TestCase("NUnit.Framework.Internal.Commands", "TestCommand", "Execute", "Commands.TestCommand is not in Unity's NUnit")]
    [TestCase("NUnit.Framework.Internal", "TestParameters", "get_Arguments", null)]
    [TestCase("NUnit.Framework", "Assert", "That", null)]
    public void Check_MemberMissingInUnitysNUnit_IsReported(string space, string type, string method, string reported)
    {
        var nunit = new AssemblyNameReference("nunit.framework", new System.Version(3, 6));
        m_package.Module.AssemblyReferences.Add(nunit);
        m_package.Emit(OpCodes.Call,
            m_package.Method(new TypeReference(space, type, m_package.Module, nunit), method, m_void, true));

        Assert.That(m_package.Check(), reported == null ? Is.Empty : Has.Some.Contains(reported));
    }

    [Test]
    public void Check_OtherParameter_IsReported()
    {
        Call("Get", m_int, false, m_package.Module.TypeSystem.Int64);

        Reports("Unity.Things.Box`1.Get(System.Int64) is not in the list");
    }

    [Test]
    public void Check_OtherReturnType_IsReported()
    {
        Call("Get", m_package.Module.TypeSystem.Int64, false, m_int);

        Reports("Unity.Things.Box`1.Get(System.Int32) returns `0 in Unity, System.Int64 here");
    }

    [Test]
    public void Check_StaticTakenForInstance_IsReported()
    {
        GenericInstanceType box = m_package.Box(m_int);
        var own = new GenericInstanceType(box.ElementType);
        own.GenericArguments.Add(box.ElementType.GenericParameters[0]);
        m_package.Emit(OpCodes.Call, m_package.Method(box, "Make", own, false, m_int));

        Reports("Unity.Things.Box`1.Make(System.Int32) is static");
    }

    [TestCase("6000.0", true)]
    [TestCase("6000.3", true)]
    [TestCase("6000.5", false)]
    public void Check_MethodOfTheNewestGeneration_IsReportedInOlderOnes(string generation, bool isReported)
    {
        Call("New", m_void, false);

        Assert.That(m_package.Check(generation).Any(p => p.Contains("Box`1.New is not in the list")), Is.EqualTo(isReported));
    }

    [TestCase("6000.3", false)]
    [TestCase("6000.5", true)]
    public void Check_ObsoleteAsError_IsReportedInItsGenerations(string generation, bool isReported)
    {
        Call("Old", m_void, false);

        Assert.That(m_package.Check(generation).Any(p => p.Contains("Box`1.Old is obsolete, using it is an error")),
            Is.EqualTo(isReported));
    }

    [Test]
    public void Check_ManagedArgument_IsReported()
    {
        TypeDefinition holder = m_package.Add("Holder", true);
        holder.Fields.Add(new FieldDefinition("Name", FieldAttributes.Public, m_package.Module.TypeSystem.String));
        m_package.User.Fields.Add(new FieldDefinition("A", FieldAttributes.Public, m_package.Box(holder)));

        Reports("Unity.Things.Box`1: T = FastPoints.Planted.Holder is not unmanaged");
    }

    [Test]
    public void Check_ArgumentWithoutTheInterface_IsReported()
    {
        Schedule(m_package.Add("Job", true));

        Reports("Unity.Things.Extensions.Schedule``1(``0): T = FastPoints.Planted.Job is not Unity.Things.IRun");
    }

    [Test]
    public void Check_SetterMissingInUnity_IsReported()
    {
        Call("set_Length", m_void, false, m_int);

        Reports("Unity.Things.Box`1.set_Length(System.Int32): the property has no setter");
    }

    [Test]
    public void Check_ReadonlyFieldWritten_IsReported()
    {
        m_package.Emit(OpCodes.Stsfld, new FieldReference("Limit", m_int, m_package.Box(m_int)));

        Reports("Unity.Things.Box`1.Limit is readonly");
    }

    [Test]
    public void Check_FieldOfOtherTypeAndStaticness_IsReported()
    {
        m_package.Emit(OpCodes.Ldfld, new FieldReference("Limit", m_package.Module.TypeSystem.Int64, m_package.Box(m_int)));

        Reports("Box`1.Limit is static");
        Reports("Box`1.Limit is of type System.Int32 in Unity, System.Int64 here");
    }

    [Test]
    public void Check_ClassTakenForStruct_IsReported()
    {
        m_package.User.Fields.Add(new FieldDefinition("A", FieldAttributes.Public, m_package.Type("Runner", true)));

        Reports("Unity.Things.Runner is a class");
    }

    [Test]
    public void Check_InterfaceMemberMissing_IsReported()
    {
        TypeDefinition job = m_package.Add("Job", true, null, m_package.Type("IRun", false));
        PlantedPackage.Define(job, "Run", MethodAttributes.Virtual | MethodAttributes.NewSlot);

        Reports("FastPoints.Planted.Job does not implement Run(System.Int32) of Unity.Things.IRun");
    }

    [Test]
    public void Check_OverrideOfNothing_IsReported()
    {
        TypeDefinition runner = m_package.Add("Runner", false, m_package.Type("Runner", false));
        PlantedPackage.Define(runner, "Start", MethodAttributes.Virtual);
        PlantedPackage.Define(runner, "Pause", MethodAttributes.Virtual);
        PlantedPackage.Define(runner, "Stop", MethodAttributes.Virtual);

        Reports("FastPoints.Planted.Runner overrides Pause, which Unity.Things.Runner does not have");
        Reports("FastPoints.Planted.Runner overrides Stop, which is not virtual");
    }

    [Test]
    public void Check_AbstractMemberLeftOpen_IsReported()
    {
        m_package.Add("Runner", false, m_package.Type("Runner", false));

        Reports("FastPoints.Planted.Runner does not override Start, which is abstract in Unity.Things.Runner");
    }

    [Test]
    public void Check_ProtectedMemberFromOutside_IsReported()
    {
        m_package.Emit(OpCodes.Callvirt, m_package.Method(m_package.Type("Runner", false), "Start", m_void, false));

        Reports("Unity.Things.Runner.Start is protected");
    }

    [Test]
    public void Check_AttributePropertyMissingInUnity_IsReported()
    {
        Mark("Depth");

        Reports("Unity.Things.MarkAttribute.set_Depth(System.Int32) is not in the list");
    }

    [Test]
    public void Check_AssemblyMissingInTheAsmdef_IsReported()
    {
        Call("Get", m_int, false, m_int);

        Assert.That(m_package.Check("6000.0", "Unity.Burst"),
            Has.Some.Contains("Unity.Things.Box`1 needs a reference to Unity.Things in FastPoints.Planted.asmdef"));
    }

    [Test]
    public void Check_TypeOfAnotherAssembly_IsReported()
    {
        var late = new TypeReference("Unity.Other", "Late", m_package.Module, m_package.Things) { IsValueType = true };
        m_package.User.Fields.Add(new FieldDefinition("A", FieldAttributes.Public, late));

        Reports("Unity.Other.Late is in Unity.Other, the stand-in has it in Unity.Things");
    }

    [Test]
    public void Check_EditorTypeInAPlayersAssembly_IsReported()
    {
        var editor = new AssemblyNameReference("UnityEditor.CoreModule", new System.Version(1, 0));
        m_package.Module.AssemblyReferences.Add(editor);
        m_package.User.Fields.Add(new FieldDefinition("A", FieldAttributes.Public,
            new TypeReference("UnityEditor", "Tool", m_package.Module, editor)));

        Reports("UnityEditor.Tool is the editor's, and FastPoints.Planted goes into players");
    }

    [Test]
    public void Check_LibraryMissingInUnity_IsReported()
    {
        m_package.Module.AssemblyReferences.Add(
            new AssemblyNameReference("System.Runtime.CompilerServices.Unsafe", new System.Version(6, 0)));

        Reports("references System.Runtime.CompilerServices.Unsafe, which Unity does not have");
    }

    [Test]
    public void Check_StandInWithOtherByReferenceKind_IsReported()
    {
        m_package.ProvideStandIn(module =>
        {
            var box = new TypeDefinition("Unity.Things", "Box`1", TypeAttributes.Public | TypeAttributes.SequentialLayout,
                new TypeReference("System", "ValueType", module, module.TypeSystem.CoreLibrary));
            box.GenericParameters.Add(new GenericParameter("T", box));
            var attempt = new MethodDefinition("Try", MethodAttributes.Public, module.TypeSystem.Boolean);
            attempt.Parameters.Add(new ParameterDefinition("item", ParameterAttributes.None,
                new ByReferenceType(box.GenericParameters[0])));
            box.Methods.Add(attempt);
            module.Types.Add(box);
        });
        GenericInstanceType instance = m_package.Box(m_int);
        m_package.Emit(OpCodes.Call, m_package.Method(instance, "Try", m_package.Module.TypeSystem.Boolean, false,
            new ByReferenceType(instance.ElementType.GenericParameters[0])));

        Reports("Box`1.Try(`0@) parameter value is by out in Unity, ref here");
        Reports("Box`1.Try(`0@) parameter 1 is called value in Unity, item here");
    }

    private void Reports(string text)
    {
        IReadOnlyCollection<string> problems = m_package.Check();

        Assert.That(problems, Has.Some.Contains(text));
        Assert.That(problems, Has.All.StartWith("6000.0 FastPoints.Planted: "));
    }

    private void Call(string name, TypeReference returns, bool isStatic, params TypeReference[] parameters) =>
        m_package.Emit(OpCodes.Call, m_package.Method(m_package.Box(m_int), name, returns, isStatic, parameters));

    private void Schedule(TypeDefinition job)
    {
        MethodReference schedule = m_package.Method(m_package.Type("Extensions", false), "Schedule", m_void, true);
        schedule.GenericParameters.Add(new GenericParameter(schedule));
        schedule.Parameters.Add(new ParameterDefinition(schedule.GenericParameters[0]));
        var instance = new GenericInstanceMethod(schedule);
        instance.GenericArguments.Add(job);
        m_package.Emit(OpCodes.Call, instance);
    }

    private void Mark(string property)
    {
        var attribute = new CustomAttribute(m_package.Method(m_package.Type("MarkAttribute", false), ".ctor", m_void, false));
        attribute.Properties.Add(new CustomAttributeNamedArgument(property, new CustomAttributeArgument(m_int, 1)));
        m_package.User.CustomAttributes.Add(attribute);
    }
}
