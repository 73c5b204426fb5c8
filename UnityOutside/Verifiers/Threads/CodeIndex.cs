namespace UnityOutside.Threads;

internal readonly record struct Site(MethodDefinition Method, Instruction At);

internal sealed class CodeIndex
{
    private static readonly Site[] s_none = { };

    private readonly HashSet<ModuleDefinition> m_modules;
    private readonly List<TypeDefinition> m_types;
    private readonly Dictionary<MethodDefinition, List<Site>> m_calls = new Dictionary<MethodDefinition, List<Site>>();
    private readonly Dictionary<FieldDefinition, List<Site>> m_writes = new Dictionary<FieldDefinition, List<Site>>();
    private readonly HashSet<FieldDefinition> m_lent = new HashSet<FieldDefinition>();
    private readonly List<Site> m_delegates = new List<Site>();
    private readonly HashSet<MethodDefinition> m_inDelegates = new HashSet<MethodDefinition>();
    private readonly Dictionary<string, List<TypeReference>> m_arguments = new Dictionary<string, List<TypeReference>>();
    private readonly Dictionary<MethodDefinition, StackFlow> m_flows = new Dictionary<MethodDefinition, StackFlow>();

    internal CodeIndex(IEnumerable<ModuleDefinition> modules)
    {
        m_modules = modules.ToHashSet();
        m_types = m_modules.SelectMany(m => m.GetTypes()).ToList();
        foreach (MethodDefinition method in Methods)
        {
            foreach (Instruction at in method.Body.Instructions)
            {
                Add(new Site(method, at));
                AddArguments(at.Operand);
            }
        }
    }

    internal IReadOnlyList<TypeDefinition> Types => m_types;
    internal IEnumerable<MethodDefinition> Methods => m_types.SelectMany(t => t.Methods).Where(m => m.HasBody);
    internal IReadOnlyList<Site> Delegates => m_delegates;

    internal bool IsInside(MemberReference member) => member is IMemberDefinition && m_modules.Contains(member.Module);

    internal StackFlow Flow(MethodDefinition method)
    {
        if (!m_flows.TryGetValue(method, out StackFlow? flow))
            m_flows.Add(method, flow = new StackFlow(method.Body));
        return flow;
    }

    internal IReadOnlyList<Site> Writes(FieldDefinition field) =>
        m_writes.TryGetValue(field, out List<Site>? sites) ? sites : s_none;

    /// <summary>Whether some code takes a field's address: it may be written through it.</summary>
    internal bool IsLent(FieldDefinition field) => m_lent.Contains(field);

    /// <param name="isComplete">False where others may call it: Unity, .NET, whoever has a delegate of it.</param>
    internal IReadOnlyList<Site> Calls(MethodDefinition method, out bool isComplete)
    {
        isComplete = !m_inDelegates.Contains(method);
        var calls = new List<Site>();
        foreach (MethodDefinition slot in Slots(method))
        {
            isComplete &= IsInside(slot);
            if (m_calls.TryGetValue(slot, out List<Site>? sites))
                calls.AddRange(sites);
        }
        return calls;
    }

    internal IEnumerable<TypeReference> Instances(GenericParameter parameter)
    {
        var seen = new HashSet<string> { KeyOf(parameter) };
        var open = new Queue<string>(seen);
        while (open.TryDequeue(out string? key))
        {
            if (!m_arguments.TryGetValue(key, out List<TypeReference>? arguments))
                continue;
            foreach (TypeReference argument in arguments)
            {
                if (argument is not GenericParameter other)
                    yield return argument;
                else if (seen.Add(KeyOf(other)))
                    open.Enqueue(KeyOf(other));
            }
        }
    }

    private static string KeyOf(GenericParameter parameter) => KeyOf(parameter.Owner, parameter.Position);

    private static string KeyOf(object owner, int position) => owner switch
    {
        MethodReference method => $"{method.DeclaringType.GetElementType().FullName}.{method.Name}/{method.Parameters.Count}",
        _ => ((TypeReference)owner).GetElementType().FullName,
    } + "!" + position;

    private void AddArguments(object? operand)
    {
        if (operand is GenericInstanceMethod method)
            AddArguments(method.ElementMethod, method.GenericArguments);
        TypeReference? type = operand as TypeReference ?? (operand as MemberReference)?.DeclaringType;
        if (type is GenericInstanceType instance)
            AddArguments(instance.ElementType, instance.GenericArguments);
    }

    private void AddArguments(MemberReference owner, IList<TypeReference> arguments)
    {
        for (int i = 0; i < arguments.Count; i++)
        {
            string key = KeyOf(owner, i);
            if (!m_arguments.TryGetValue(key, out List<TypeReference>? known))
                m_arguments.Add(key, known = new List<TypeReference>());
            if (known.TrueForAll(k => k.FullName != arguments[i].FullName || arguments[i] is GenericParameter))
                known.Add(arguments[i]);
        }
    }

    private static IEnumerable<MethodDefinition> Slots(MethodDefinition method)
    {
        yield return method;
        if (!method.IsVirtual)
            yield break;
        foreach (TypeDefinition? type in TypeRelations.AllOf(TypeRelations.Self(method.DeclaringType)).Select(Resolution.Of))
        {
            foreach (MethodDefinition slot in type?.Methods.ToArray() ?? new MethodDefinition[0])
            {
                bool isSlot = slot != method && slot.IsVirtual && (method.Overrides.Any(o => Resolution.Of(o) == slot)
                    || (slot.Name == method.Name && slot.Parameters.Count == method.Parameters.Count));
                if (isSlot)
                    yield return slot;
            }
        }
    }

    private void Add(Site site)
    {
        switch (site.At.OpCode.Code)
        {
            case Code.Newobj when TypeRelations.IsDelegate(((MethodReference)site.At.Operand).DeclaringType):
                m_delegates.Add(site);
                break;
            case Code.Call or Code.Callvirt or Code.Newobj:
                if (Resolution.Of((MethodReference)site.At.Operand) is { } called)
                    Add(m_calls, called, site);
                break;
            case Code.Ldftn or Code.Ldvirtftn:
                if (Resolution.Of((MethodReference)site.At.Operand) is { } target)
                    m_inDelegates.Add(target);
                break;
            case Code.Stfld or Code.Stsfld:
                if (Definition(site.At) is { } written)
                    Add(m_writes, written, site);
                break;
            case Code.Ldflda or Code.Ldsflda:
                if (Definition(site.At) is { } lent)
                    m_lent.Add(lent);
                break;
        }
    }

    private FieldDefinition? Definition(Instruction at) =>
        Resolution.Of((FieldReference)at.Operand) is { } field && IsInside(field) ? field : null;

    private static void Add<TKey>(Dictionary<TKey, List<Site>> sites, TKey key, Site site) where TKey : notnull
    {
        if (!sites.TryGetValue(key, out List<Site>? list))
            sites.Add(key, list = new List<Site>());
        list.Add(site);
    }
}
