namespace UnityOutside.Threads;

/// <summary>Puts at the beginning of each member that Unity keeps to the main thread what refuses other threads, as the native
/// code behind it does: <c>StandIns.MainThread.Require("get_isPlaying")</c>. There are hundreds of them, most of one line; the
/// table of threads says which, so that nobody can forget one.</summary>
public sealed class MainThreadGuards(ThreadTable table)
{
    private const string GuardAssembly = "UnityEngine.CoreModule", GuardType = "MainThread", GuardMethod = "Require";

    /// <summary>Such members are for any thread while their objects are there, and guard themselves where they are not.</summary>
    private const string SoftReason = "M:UnityEngine.Object.EnsureRunningOnMainThread";

    private readonly ThreadTable m_table = table;

    public int Guard(string file, IEnumerable<string> references)
    {
        using var resolver = new DefaultAssemblyResolver();
        foreach (string folder in references.Select(r => Path.GetDirectoryName(Path.GetFullPath(r))!).Distinct())
            resolver.AddSearchDirectory(folder);
        using ModuleDefinition module = ModuleDefinition.ReadModule(file, new ReaderParameters
        {
            AssemblyResolver = resolver,
            InMemory = true,
            ReadSymbols = true,
        });
        int guarded = Guard(module);
        if (guarded > 0)
            module.Write(file, new WriterParameters { WriteSymbols = true });
        return guarded;
    }

    public int Guard(ModuleDefinition module)
    {
        List<MethodDefinition> open = Wanted(module).Where(m => !IsGuarded(m)).ToList();
        if (open.Count == 0)
            return 0;
        MethodReference require = Require(module);
        foreach (MethodDefinition method in open)
        {
            ILProcessor il = method.Body.GetILProcessor();
            Instruction first = method.Body.Instructions[0];
            il.InsertBefore(first, il.Create(OpCodes.Ldstr, method.Name));
            il.InsertBefore(first, il.Create(OpCodes.Call, require));
        }
        return open.Count;
    }

    /// <summary>Members of a stand-in that the table keeps to the main thread.</summary>
    public IEnumerable<MethodDefinition> Wanted(ModuleDefinition module) => module.GetTypes().Where(StandInAudit.IsVisible)
        .SelectMany(t => t.Methods)
        .Where(m => m.HasBody && (m.IsPublic || m.IsFamily || m.IsFamilyOrAssembly) && IsForMainThread(m));

    public static bool IsGuarded(MethodDefinition method) => method.Body.Instructions.Count > 1
        && method.Body.Instructions[1].Operand is MethodReference { Name: GuardMethod } called
        && called.DeclaringType.Name == GuardType;

    private bool IsForMainThread(MethodDefinition method)
    {
        ThreadRow? row = m_table.Find(method);
        if (row == null || row.Reason == SoftReason)
            return false;
        int underscore = method.IsSpecialName ? method.Name.IndexOf('_') : -1;
        string accessor = underscore < 0 ? "" : method.Name[..underscore];
        return UnityApi.Generations.Any(g => row.In(g, accessor) == "main");
    }

    private static MethodReference Require(ModuleDefinition module)
    {
        if (module.Assembly.Name.Name == GuardAssembly)
            return module.GetType("StandIns", GuardType).Methods.Single(m => m.Name == GuardMethod);
        AssemblyNameReference? assembly = module.AssemblyReferences.FirstOrDefault(a => a.Name == GuardAssembly);
        if (assembly == null)
            module.AssemblyReferences.Add(assembly = new AssemblyNameReference(GuardAssembly, new Version(0, 0)));
        var require = new MethodReference(GuardMethod, module.TypeSystem.Void,
            new TypeReference("StandIns", GuardType, module, assembly));
        require.Parameters.Add(new ParameterDefinition(module.TypeSystem.String));
        return require;
    }
}
