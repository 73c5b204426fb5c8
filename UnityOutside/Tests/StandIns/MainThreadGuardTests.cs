#if ENABLE_UNITY_COLLECTIONS_CHECKS

namespace UnityOutside.Tests.StandIns;

public sealed class MainThreadGuardTests
{
    const string Table = """
        M:Unity.Things.Box.Fill	main	extern
        M:Unity.Things.Box.Look	any	pure
        M:Unity.Things.Box.Later	any	pure	main@6000.3
        M:Unity.Things.Box.Compare	main	M:UnityEngine.Object.EnsureRunningOnMainThread
        P:Unity.Things.Box.Size	main	set:M:Unity.Things.Box.SetSize; get:any
        """;

    [Test]
    public void StandIns_EachMemberForTheMainThread_BeginsWithTheGuard()
    {
        var guards = new MainThreadGuards(ThreadTable.Load(Path.Combine(AppContext.BaseDirectory, "threads.tsv")));
        using var resolver = new DefaultAssemblyResolver();
        resolver.AddSearchDirectory(AppContext.BaseDirectory);
        var wanted = new List<MethodDefinition>();
        foreach (string file in Directory.GetFiles(AppContext.BaseDirectory, "Unity*.dll"))
            wanted.AddRange(
                guards.Wanted(ModuleDefinition.ReadModule(file, new ReaderParameters { AssemblyResolver = resolver })));
        Assert.That(wanted.Where(m => !MainThreadGuards.IsGuarded(m)).Select(m => m.FullName), Is.Empty);
        Assert.That(wanted.Count, Is.GreaterThan(400));
    }

    [Test]
    public void Guard_OfAStandIn_MatchesTheTable()
    {
        using AssemblyDefinition assembly = AssemblyDefinition.CreateAssembly(
            new AssemblyNameDefinition("Unity.Things", new Version(1, 0)), "Unity.Things", ModuleKind.Dll);
        ModuleDefinition module = assembly.MainModule;
        var box = new TypeDefinition("Unity.Things", "Box", TypeAttributes.Public, module.TypeSystem.Object);
        module.Types.Add(box);
        foreach (string name in new[] { "Fill", "Look", "Later", "Compare", "get_Size", "set_Size", "Unknown" })
            Define(box, name, MethodAttributes.Public);
        Define(box, "Fill", MethodAttributes.Private).Name = "FillInside";
        var guards = new MainThreadGuards(ThreadTable.Read(new StringReader(Table)));

        Assert.That(guards.Guard(module), Is.EqualTo(3));
        Assert.That(box.Methods.Where(MainThreadGuards.IsGuarded).Select(m => m.Name),
            Is.EqualTo(new[] { "Fill", "Later", "set_Size" }));
        Assert.That(box.Methods[0].Body.Instructions[0].Operand, Is.EqualTo("Fill"));
        Assert.That(guards.Guard(module), Is.Zero, "once is enough");
    }

    static MethodDefinition Define(TypeDefinition type, string name, MethodAttributes access)
    {
        var method = new MethodDefinition(name, access, type.Module.TypeSystem.Void) { IsSpecialName = name.Contains('_') };
        if (name.StartsWith("set_", StringComparison.Ordinal))
            method.Parameters.Add(new ParameterDefinition(type.Module.TypeSystem.Int32));
        method.Body.GetILProcessor().Append(Instruction.Create(OpCodes.Nop));
        method.Body.GetILProcessor().Append(Instruction.Create(OpCodes.Ret));
        type.Methods.Add(method);
        return method;
    }

    static TestCaseData Call(string name, Action call) => new TestCaseData(name, call).SetArgDisplayNames(name);

    static readonly TestCaseData[] s_calls =
    {
        Call("get_isPlaying", () => _ = Application.isPlaying),
        Call("get_persistentDataPath", () => _ = Application.persistentDataPath),
        Call("get_JobWorkerCount", () => _ = JobsUtility.JobWorkerCount),
        Call("GUIDToAssetPath", () => AssetDatabase.GUIDToAssetPath("")),
        Call(".ctor", () => _ = new GameObject("planted")),
        Call("get_DefaultGameObjectInjectionWorld", () => _ = World.DefaultGameObjectInjectionWorld),
    };

    [TestCaseSource(nameof(s_calls))]
    public void Member_OnAPoolThread_IsRefusedByName(string name, Action call)
    {
        var failure = Assert.Throws<UnityException>(() => Task.Run(call).GetAwaiter().GetResult());
        Assert.That(failure.Message, Does.StartWith(name + " can only be called from the main thread.\n"
            + "Constructors and field initializers will be executed from the loading thread when loading a scene.\n"));
    }

    struct AskJob : IJob
    {
        public void Execute() => _ = Application.isPlaying;
    }

    [Test]
    public void Member_InAJob_IsRefusedOnAnyThread() =>
        Assert.That(() => new AskJob().Schedule().CompleteAndThrow(), Throws.TypeOf<UnityException>());

    [Test]
    public void Object_ComparedOnAPoolThread_IsAliveUntilDestroyed()
    {
        var texture = new Texture2D(1, 1, TextureFormat.RGBA32, false);
        bool IsThere() => Task.Run(() => texture != null && texture && !texture.Equals(null)).GetAwaiter().GetResult();
        Assert.That(IsThere(), Is.True);
        Object.DestroyImmediate(texture);
        Assert.That(() => IsThere(), Throws.InvalidOperationException.With.Message.EqualTo(
            "EnsureRunningOnMainThread can only be called from the main thread"));
        Assert.That(texture == null, Is.True);
    }
}
#endif
