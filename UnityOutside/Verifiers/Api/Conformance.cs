namespace UnityOutside.Api;

/// <summary>Compares all of Unity that an assembly's IL names with the signatures that one generation of Unity has. The assembly
/// was compiled against stand-ins, so each name is a claim: that the type or member exists, in that assembly, with that return
/// type, staticness, by-reference kinds and constraints, and that using it is no error.</summary>
public sealed class Conformance(UnityApi api, string generation, AssemblyTable assemblies)
{
    private readonly UnityApi m_api = api;
    private readonly string m_generation = generation;
    private readonly AssemblyTable m_assemblies = assemblies;
    private readonly TypeArguments m_arguments = new TypeArguments(api, generation);
    private readonly SortedSet<string> m_problems = new SortedSet<string>(StringComparer.Ordinal);
    private readonly HashSet<string> m_checked = new HashSet<string>();
    private string m_assembly = "";
    private string m_site = "";
    private TypeDefinition? m_within;

    /// <summary>What is not as Unity has it, a line each; empty if all is.</summary>
    public IReadOnlyCollection<string> Check(ModuleDefinition module)
    {
        m_problems.Clear();
        m_checked.Clear();
        m_assembly = module.Assembly.Name.Name;
        foreach (AssemblyNameReference reference in module.AssemblyReferences)
        {
            if (!Origins.IsUnity(reference.Name) && !Origins.IsThereInUnity(reference.Name)
                && !m_assemblies.Has(reference.Name))
                Add($"references {reference.Name}, which Unity does not have");
        }
        foreach (IlUse use in IlUses.Of(module))
        {
            m_site = use.Site;
            m_within = use.Within;
            Check(use);
        }
        foreach (TypeDefinition type in module.GetTypes())
        {
            m_site = DocId.DefinitionName(type);
            m_within = type;
            m_problems.UnionWith(new Inheritance(m_api, m_generation).Problems(type).Select(Line));
        }
        return m_problems.ToList();
    }

    private void Check(IlUse use)
    {
        if (UnityNUnit.FindAbsent(use.Member) is { } absent)
            Add($"{absent} is not in Unity's NUnit");
        switch (use.Member)
        {
            case TypeReference type:
                CheckType(type);
                break;
            case MethodReference method:
                CheckType(method.DeclaringType);
                CheckType(method.ReturnType);
                foreach (ParameterDefinition parameter in method.Parameters)
                    CheckType(parameter.ParameterType);
                CheckMethod(method);
                break;
            case FieldReference field:
                CheckType(field.DeclaringType);
                CheckType(field.FieldType);
                CheckField(field, use.Code);
                break;
        }
    }

    private void CheckType(TypeReference type)
    {
        switch (type)
        {
            case GenericParameter:
                return;
            case GenericInstanceType instance:
                foreach (TypeReference argument in instance.GenericArguments)
                    CheckType(argument);
                CheckType(instance.ElementType);
                CheckArguments(instance);
                return;
            case RequiredModifierType required:
                CheckType(required.ModifierType);
                break;
            case FunctionPointerType function:
                CheckType(function.ReturnType);
                foreach (ParameterDefinition parameter in function.Parameters)
                    CheckType(parameter.ParameterType);
                return;
        }
        if (type is TypeSpecification wrapped)
        {
            CheckType(wrapped.ElementType);
            return;
        }
        string assembly = Origins.AssemblyOf(type);
        if (!Origins.IsUnity(assembly) || !m_checked.Add(DocId.OfType(type)))
            return;
        ApiRow? row = m_api.Find(DocId.OfType(type), m_generation);
        if (row == null)
        {
            Add($"{DocId.DefinitionName(type)} is not in {m_api.Name}");
            return;
        }
        CheckUsable(row, DocId.DefinitionName(type));
        if (!Origins.AssembliesOf(row).Contains(assembly))
            Add($"{DocId.DefinitionName(type)} is in {row.Assembly}, the stand-in has it in {assembly}");
        // A reference says what it is in signatures only, not where a static method of it is called.
        bool isValue = type.IsValueType || Resolution.Of(type)?.IsValueType == true;
        if (isValue != (row.Kind == "struct" || row.Kind == "enum"))
            Add($"{DocId.DefinitionName(type)} is a {row.Kind}");
        if (Origins.ReferenceFor(row) is { } needed && !m_assemblies.References(m_assembly).Contains(needed))
            Add($"{DocId.DefinitionName(type)} needs a reference to {needed} in {m_assembly}.asmdef");
        if (Origins.IsEditor(row) && !m_assemblies.IsEditor(m_assembly))
            Add($"{DocId.DefinitionName(type)} is the editor's, and {m_assembly} goes into players");
    }

    private void CheckArguments(GenericInstanceType instance)
    {
        if (!Origins.IsUnity(Origins.AssemblyOf(instance)) || m_api.Find(DocId.OfType(instance), m_generation) is not { } row)
            return;
        List<TypeReference> arguments = instance.GenericArguments.ToList();
        foreach (string misfit in m_arguments.Misfits(row.Constraints, arguments, arguments, new List<TypeReference>()))
            Add($"{DocId.DefinitionName(instance)}: {misfit}");
    }

    private void CheckMethod(MethodReference method)
    {
        if (method.DeclaringType is ArrayType || !Origins.IsUnity(Origins.AssemblyOf(method.DeclaringType)))
            return;
        ApiRow? type = m_api.Find(DocId.OfType(method.DeclaringType), m_generation);
        if (type == null)
            return;
        string shown = DocId.OfMethod(method)[2..];
        if (type.Kind == "delegate")
        {
            if (method.Name == "Invoke")
                Same(shown, "returns", type.Type, DocId.InSignature(method.ReturnType));
            return;
        }
        ApiRow? row = FindMethod(type, method);
        if (row == null)
        {
            Add($"{shown} is not in {m_api.Name}");
            return;
        }
        CheckUsable(row, shown);
        if (row.IsStatic == method.HasThis)
            Add($"{shown} is {(row.IsStatic ? "static" : "an instance's")}");
        CheckProtected(row, shown);
        if (row.Id[0] == 'P')
            CheckAccessor(row, method, shown);
        else if (row.Id[0] == 'M' && row.Kind != "ctor")
            Same(shown, "returns", ReturnOf(row), DocId.InSignature(method.ReturnType));
        CheckParameters(row, method, shown);
        if (method is GenericInstanceMethod instance)
        {
            foreach (TypeReference argument in instance.GenericArguments)
                CheckType(argument);
            var ofType = method.DeclaringType is GenericInstanceType generic
                ? generic.GenericArguments.ToList()
                : new List<TypeReference>();
            List<TypeReference> ofMethod = instance.GenericArguments.ToList();
            foreach (string misfit in m_arguments.Misfits(row.Constraints, ofMethod, ofType, ofMethod))
                Add($"{shown}: {misfit}");
        }
    }

    private ApiRow? FindMethod(ApiRow type, MethodReference method)
    {
        for (ApiRow? at = type; at != null; at = at.Type.Length == 0 ? null : m_api.Find("T:" + at.Type, m_generation))
        {
            string name = at.Id[2..];
            ApiRow? row = m_api.Find(DocId.OfMethod(name, method), m_generation);
            if (row == null && DocId.OfAccessor(name, method) is { } accessor)
                row = m_api.Find(accessor, m_generation);
            if (row != null)
                return row;
            if (at.Kind != "class")
                break;
        }
        return null;
    }

    private void CheckAccessor(ApiRow row, MethodReference method, string shown)
    {
        bool sets = method.Name.StartsWith("set_", StringComparison.Ordinal);
        if (!row.Has(sets ? "set" : "get"))
            Add($"{shown}: the property has no {(sets ? "setter" : "getter")}");
        string type = sets ? DocId.InSignature(method.Parameters[^1].ParameterType) : DocId.InSignature(method.ReturnType);
        Same(shown, "is of type", sets ? row.Type : ReturnOf(row), type);
    }

    private void CheckParameters(ApiRow row, MethodReference method, string shown)
    {
        MethodDefinition? definition = Resolution.Of(method);
        if (definition == null || row.Id[0] != 'M')
            return;
        IReadOnlyList<ApiParameter> wanted = row.Parameters();
        for (int i = 0; i < Math.Min(wanted.Count, definition.Parameters.Count); i++)
        {
            ParameterDefinition have = definition.Parameters[i];
            Same(shown, $"parameter {wanted[i].Name} is by", OrValue(wanted[i].Kind), OrValue(StandInAudit.KindOf(have)));
            Same(shown, $"parameter {i + 1} is called", wanted[i].Name, have.Name);
        }
    }

    private static string OrValue(string kind) => kind.Length == 0 ? "value" : kind;

    private void CheckField(FieldReference field, Code? code)
    {
        if (!Origins.IsUnity(Origins.AssemblyOf(field.DeclaringType))
            || m_api.Find(DocId.OfType(field.DeclaringType), m_generation) == null)
            return;
        string shown = DocId.OfField(field)[2..];
        ApiRow? row = m_api.Find(DocId.OfField(field), m_generation);
        if (row == null)
        {
            Add($"{shown} is not in {m_api.Name}");
            return;
        }
        CheckUsable(row, shown);
        CheckProtected(row, shown);
        Same(shown, "is of type", row.Type, DocId.InSignature(field.FieldType));
        bool isStatic = code is Code.Ldsfld or Code.Ldsflda or Code.Stsfld;
        if (code != null && isStatic != row.IsStatic)
            Add($"{shown} is {(row.IsStatic ? "static" : "an instance's")}");
        if (code is Code.Stfld or Code.Stsfld && row.Has("readonly"))
            Add($"{shown} is readonly");
    }

    private void CheckUsable(ApiRow row, string shown)
    {
        if (row.IsError(m_generation))
            Add($"{shown} is obsolete, using it is an error");
    }

    private void CheckProtected(ApiRow row, string shown)
    {
        if (!row.Has("protected"))
            return;
        string owner = DocId.DeclaringTypeOf(row.Id);
        for (TypeReference? type = m_within; type != null; type = Resolution.Of(type)?.BaseType)
        {
            if (DocId.DefinitionName(type) == owner)
                return;
        }
        Add($"{shown} is protected");
    }

    private void Same(string shown, string what, string wanted, string got)
    {
        if (wanted != got)
            Add($"{shown} {what} {wanted} in Unity, {got} here");
    }

    private static string ReturnOf(ApiRow row) =>
        row.Has("ref-return") || row.Has("ref-readonly-return") ? row.Type + "@" : row.Type;

    private void Add(string problem) => m_problems.Add(Line($"{problem} (named in {m_site})"));
    private string Line(string problem) => $"{m_generation} {m_assembly}: {problem}";
}
