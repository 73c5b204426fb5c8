namespace UnityOutside.Hpc;

/// <summary>Walks the IL that is reachable from each job and each [BurstCompile] method and says what Burst would reject. .NET
/// runs it all, so without this walk a build here proves nothing of Burst. It stops at Unity's and .NET's own API, by an allow
/// rule (<see cref="HpcBoundary"/>), and walks each instance of generic code by itself.</summary>
public sealed class HpcVerifier
{
    private readonly HashSet<ModuleDefinition> m_modules;
    private readonly SortedSet<string> m_problems = new SortedSet<string>(StringComparer.Ordinal);
    private readonly HashSet<string> m_seen = new HashSet<string>();
    private readonly Queue<HpcVisit> m_visits = new Queue<HpcVisit>();
    private string m_entry = "";

    public HpcVerifier(IEnumerable<ModuleDefinition> modules) => m_modules = modules.ToHashSet();

    public int WalkedCount { get; private set; }

    /// <summary>One line for each thing that Burst would reject in what those types start: entry, calls, place, why.</summary>
    public IReadOnlyCollection<string> Verify(Func<TypeDefinition, bool> isAsked)
    {
        m_problems.Clear();
        WalkedCount = 0;
        foreach (ModuleDefinition module in m_modules)
        {
            foreach (TypeDefinition job in HpcEntries.Jobs(module).Where(HpcEntries.IsCompiled).Where(isAsked))
                VerifyJob(job);
            foreach (MethodDefinition method in HpcEntries.Methods(module).Where(m => isAsked(m.DeclaringType)))
                VerifyMethod(method);
        }
        return m_problems.ToList();
    }

    private void VerifyJob(TypeDefinition job)
    {
        m_entry = DocId.DefinitionName(job);
        if (job.HasGenericParameters)
        {
            Report("a generic job needs registering for each type that it runs with");
            return;
        }
        if (HpcLayout.Objection(job) is { } inLayout)
            Report(inLayout);
        foreach (FieldDefinition field in job.Fields.Where(f => !f.IsStatic))
        {
            if ((HpcTypes.Objection(field.FieldType) ?? HpcSignature.OfField(field.FieldType)) is { } objection)
                Report($"field {field.Name} is {objection}");
        }
        foreach (MethodDefinition method in HpcEntries.OfJob(job))
            Walk(method);
    }

    private void VerifyMethod(MethodDefinition method)
    {
        m_entry = DocId.DefinitionName(method.DeclaringType) + "." + method.Name;
        if (!HpcEntries.IsCompiled(method.DeclaringType))
            Report("its type has no [BurstCompile], so Burst does not look for it");
        if (method.HasGenericParameters || method.DeclaringType.HasGenericParameters)
        {
            Report("a generic method cannot be called from managed code through Burst");
            return;
        }
        // Systems and jobs are called by generated code, which knows how.
        foreach (string objection in method.IsStatic ? HpcSignature.OfEntry(method) : Enumerable.Empty<string>())
            Report(objection);
        Walk(method);
    }

    private void Walk(MethodDefinition entry)
    {
        m_seen.Clear();
        Enqueue(entry, GenericScope.None, "", false);
        while (m_visits.TryDequeue(out HpcVisit? visit))
        {
            WalkedCount++;
            new HpcWalk(this, visit).Run();
        }
    }

    internal bool IsWalked(ModuleDefinition module) => m_modules.Contains(module);

    internal void Report(string problem) => m_problems.Add($"{m_entry}: {problem}");

    internal void Enqueue(MethodDefinition method, GenericScope scope, string path, bool isStaticConstructor)
    {
        if (!m_seen.Add(method.FullName + "|" + scope.Key))
            return;
        string step = DocId.DefinitionName(method.DeclaringType).Split('.')[^1] + "." + method.Name;
        m_visits.Enqueue(new HpcVisit(method, scope, path.Length == 0 ? step : path + " > " + step, isStaticConstructor));
    }
}
