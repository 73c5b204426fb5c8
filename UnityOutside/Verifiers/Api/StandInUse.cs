namespace UnityOutside.Api;

/// <summary>Finds what stand-ins show that no compiled code names: it is carried for nothing. Overloads of one name count as one,
/// since C# takes another overload silently where one is gone.</summary>
public sealed class StandInUse
{
    private static readonly string[] s_messages = { "OnEnable", "OnDisable", "OnDestroy" };

    private readonly HashSet<string> m_names = new HashSet<string>(StringComparer.Ordinal);
    private readonly HashSet<string> m_virtual = new HashSet<string>(StringComparer.Ordinal);
    private string m_within = "";

    public static IEnumerable<string> Check(IReadOnlyList<string> files, IEnumerable<string> standIns, string folder)
    {
        var use = new StandInUse();
        var unnamed = new SortedSet<string>(StringComparer.Ordinal);
        using var resolver = new DefaultAssemblyResolver();
        resolver.AddSearchDirectory(folder);
        var reading = new ReaderParameters { AssemblyResolver = resolver };
        foreach (string file in files)
        {
            using ModuleDefinition module = ModuleDefinition.ReadModule(file, reading);
            use.Count(module);
        }
        foreach (string file in files.Where(f => standIns.Contains(Path.GetFileNameWithoutExtension(f))))
        {
            using ModuleDefinition module = ModuleDefinition.ReadModule(file, reading);
            unnamed.UnionWith(use.Unnamed(module));
        }
        return unnamed.Select(id => $"{id} is in a stand-in, and no compiled code names it");
    }

    public void Count(ModuleDefinition module)
    {
        foreach (IlUse use in IlUses.Of(module))
        {
            m_within = use.Within == null ? "" : DocId.DefinitionName(use.Within) + ".";
            Count(use.Member);
        }
        foreach (MethodDefinition method in module.GetTypes().SelectMany(t => t.Methods)
            .Where(m => m.IsVirtual && (!m.IsNewSlot || m.IsFinal)))
            m_virtual.Add(LastName(method.Name));
    }

    public IEnumerable<string> Unnamed(ModuleDefinition standIn)
    {
        foreach (TypeDefinition type in standIn.GetTypes().Where(StandInAudit.IsVisible))
        {
            // Constants alone: the compiler leaves no name of them.
            if (!type.IsEnum && !type.HasMethods && type.HasFields && type.Fields.All(f => f.IsLiteral))
                continue;
            if (!m_names.Contains(DocId.DefinitionName(type)))
            {
                yield return DocId.OfType(type);
                continue;
            }
            if (type.IsEnum || type.BaseType?.FullName == "System.MulticastDelegate")
                continue;
            foreach (FieldDefinition field in type.Fields.Where(f => !IsNamed(f)))
                yield return DocId.OfField(field);
            foreach (string id in type.Methods.Where(m => !IsNamed(m)).Select(IdOf).Distinct())
                yield return id;
        }
    }

    private void Count(MemberReference member)
    {
        switch (member)
        {
            case TypeReference type:
                Count(type);
                break;
            case MethodReference method:
                Count(method.DeclaringType);
                Count(method.ReturnType);
                foreach (ParameterDefinition parameter in method.Parameters)
                    Count(parameter.ParameterType);
                if (method is GenericInstanceMethod instance)
                {
                    foreach (TypeReference argument in instance.GenericArguments)
                        Count(argument);
                }
                m_names.Add(Family(method));
                break;
            case FieldReference field:
                Count(field.DeclaringType);
                Count(field.FieldType);
                m_names.Add(Family(field));
                break;
        }
    }

    private void Count(TypeReference? type)
    {
        switch (type)
        {
            case null:
            case GenericParameter:
                return;
            case FunctionPointerType function:
                Count(function.ReturnType);
                foreach (ParameterDefinition parameter in function.Parameters)
                    Count(parameter.ParameterType);
                return;
            case GenericInstanceType instance:
                foreach (TypeReference argument in instance.GenericArguments)
                    Count(argument);
                break;
        }
        if (type is TypeSpecification wrapped)
        {
            Count(wrapped.ElementType);
            return;
        }
        // A type that only its own members name is not named.
        if (m_within.StartsWith(DocId.DefinitionName(type) + ".", StringComparison.Ordinal))
            return;
        for (TypeReference? level = type; level != null; level = level.DeclaringType)
            m_names.Add(DocId.DefinitionName(level));
    }

    private bool IsNamed(FieldDefinition field) => !StandInAudit.IsVisible(field.Attributes) || field.HasConstant
        || field.IsSpecialName || (!field.IsStatic && field.DeclaringType.IsValueType) || m_names.Contains(Family(field));

    private bool IsNamed(MethodDefinition method)
    {
        if (!(method.IsPublic || method.IsFamily || method.IsFamilyOrAssembly) || method.IsConstructor
            || s_messages.Contains(method.Name) || method.Name.StartsWith("op_", StringComparison.Ordinal))
            return true;
        TypeDefinition type = method.DeclaringType;
        if (type.IsValueType && type.Fields.Any(f => f.Name == $"<{NameOf(method)}>k__BackingField"))
            return true;
        if (method.IsVirtual && (method.IsFinal || !method.IsNewSlot || m_virtual.Contains(method.Name)))
            return true;
        return m_names.Contains(Family(method));
    }

    private static string Family(MemberReference member) => DocId.DefinitionName(member.DeclaringType) + "." + NameOf(member);

    private static string IdOf(MethodDefinition method) =>
        (method.IsSpecialName ? DocId.OfAccessor(DocId.DefinitionName(method.DeclaringType), method) : null)
        ?? DocId.OfMethod(method);

    private static string NameOf(MemberReference member)
    {
        string? accessor = new[] { "get_", "set_", "add_", "remove_" }
            .FirstOrDefault(a => member is MethodReference && member.Name.StartsWith(a, StringComparison.Ordinal));
        return member.Name[(accessor?.Length ?? 0)..];
    }

    private static string LastName(string name) => name[(name.LastIndexOf('.') + 1)..];
}
