namespace UnityOutside.Api;

/// <summary>Whether a stand-in's public face is Unity's. Constants, enum values and default arguments go into the IL of who uses
/// them without a trace, so what the IL names is not enough: what could be named must be right. What the host needs beside it is
/// in namespaces that begin with UnityOutside.</summary>
public sealed class StandInAudit(UnityApi fullApi)
{
    private readonly UnityApi m_api = fullApi;
    private readonly List<string> m_problems = new List<string>();

    public static string KindOf(ParameterDefinition parameter)
    {
        if (!(parameter.ParameterType is ByReferenceType || parameter.ParameterType is RequiredModifierType))
            return "";
        if (parameter.IsOut && !parameter.IsIn)
            return "out";
        return parameter.CustomAttributes.Any(a => a.AttributeType.Name == "IsReadOnlyAttribute")
            || parameter.ParameterType is RequiredModifierType ? "in" : "ref";
    }

    public IReadOnlyList<string> Check(ModuleDefinition module)
    {
        m_problems.Clear();
        foreach (TypeDefinition type in module.GetTypes().Where(IsVisible))
        {
            if (DocId.DefinitionName(type).StartsWith("UnityOutside.", StringComparison.Ordinal))
                continue;
            ApiRow? row = m_api.FindAny(DocId.OfType(type));
            if (row == null)
            {
                m_problems.Add($"{DocId.OfType(type)} is not Unity's");
                continue;
            }
            if (!Origins.AssembliesOf(row).Contains(module.Assembly.Name.Name))
                m_problems.Add($"{row.Id} is in {row.Assembly}, not in {module.Assembly.Name.Name}");
            if (KindOf(type) != row.Kind)
                m_problems.Add($"{row.Id} is a {row.Kind}, not a {KindOf(type)}");
            if (row.Kind != "delegate")
                CheckMembers(type, row);
        }
        return m_problems.ToList();
    }

    private void CheckMembers(TypeDefinition type, ApiRow typeRow)
    {
        foreach (FieldDefinition field in type.Fields.Where(f => IsVisible(f.Attributes) && !f.IsSpecialName))
        {
            ApiRow? row = FindAnywhere(typeRow, _ => DocId.OfField(field));
            if (row == null)
                m_problems.Add($"{DocId.OfField(field)} is not Unity's");
            else if (field.HasConstant)
                CheckConstant(field, row);
        }
        foreach (MethodDefinition method in type.Methods.Where(m => (m.IsPublic || m.IsFamily || m.IsFamilyOrAssembly)))
        {
            if (IsImplied(method))
                continue;
            ApiRow? row = FindAnywhere(typeRow, owner => DocId.OfMethod(owner, method))
                ?? FindAnywhere(typeRow, owner => DocId.OfAccessor(owner, method) ?? "");
            if (row == null)
                m_problems.Add($"{DocId.OfMethod(method)} is not Unity's");
            else
                CheckMethod(method, row);
        }
    }

    private ApiRow? FindAnywhere(ApiRow typeRow, Func<string, string> idOn)
    {
        for (ApiRow? at = typeRow; at != null; at = at.Type.Length == 0 ? null : m_api.FindAny("T:" + at.Type))
        {
            if (m_api.FindAny(idOn(at.Id[2..])) is { } row)
                return row;
            if (at.Kind != "class")
                return null;
        }
        return null;
    }

    private void CheckMethod(MethodDefinition method, ApiRow row)
    {
        IEnumerable<ApiRow> versions = UnityApi.Generations.Where(row.IsIn).Select(row.As).Append(row);
        List<string>? nearest = null;
        foreach (ApiRow version in versions)
        {
            List<string> differences = Differences(method, version);
            if (differences.Count == 0)
                return;
            nearest ??= differences;
        }
        m_problems.AddRange(nearest!.Select(d => $"{row.Id}: {d}"));
    }

    private static List<string> Differences(MethodDefinition method, ApiRow row)
    {
        var differences = new List<string>();
        if (row.IsStatic != method.IsStatic)
            differences.Add(row.IsStatic ? "is static in Unity" : "is an instance's in Unity");
        string returns = row.Type + (row.Has("ref-return") || row.Has("ref-readonly-return") ? "@" : "");
        string have = method.Name.StartsWith("set_", StringComparison.Ordinal)
            ? row.Has("set") ? row.Type : "no setter"
            : DocId.InSignature(method.ReturnType);
        if (method.Name.StartsWith("set_", StringComparison.Ordinal))
            returns = row.Type;
        if (row.Kind != "ctor" && row.Kind != "event" && returns != have)
            differences.Add($"is {returns} in Unity, {have} here");
        if (row.Id[0] != 'M')
            return differences;
        IReadOnlyList<ApiParameter> wanted = row.Parameters();
        for (int i = 0; i < Math.Min(wanted.Count, method.Parameters.Count); i++)
        {
            ParameterDefinition parameter = method.Parameters[i];
            if (parameter.Name != wanted[i].Name)
                differences.Add($"parameter {i + 1} is called {wanted[i].Name} in Unity, {parameter.Name} here");
            if (KindOf(parameter) != wanted[i].Kind)
                differences.Add($"parameter {wanted[i].Name} is by '{wanted[i].Kind}' in Unity, '{KindOf(parameter)}' here");
            string? fallback = wanted[i].Default;
            if (parameter.IsOptional != (fallback != null))
                differences.Add($"parameter {wanted[i].Name} is {(fallback != null ? "" : "not ")}optional in Unity");
            else if (fallback != null && parameter.HasConstant && parameter.Constant != null &&
                !SameValue(fallback, parameter.Constant))
                differences.Add($"parameter {wanted[i].Name} is {fallback} by default, {parameter.Constant} here");
        }
        return differences;
    }

    private void CheckConstant(FieldDefinition field, ApiRow row)
    {
        IEnumerable<ApiRow> versions = UnityApi.Generations.Where(row.IsIn).Select(row.As).Append(row);
        if (!versions.Any(v => v.Value is { } value && SameValue(value, field.Constant)))
            m_problems.Add($"{row.Id} is {row.Value} in Unity, {field.Constant} here");
    }

    private static bool SameValue(string text, object value)
    {
        switch (value)
        {
            case float single:
                return text.EndsWith('f') && float.TryParse(text[..^1], CultureInfo.InvariantCulture, out float f)
                    && f.Equals(single);
            case double number:
                return double.TryParse(text, CultureInfo.InvariantCulture, out double d) && d.Equals(number);
            case bool flag:
                return text == (flag ? "true" : "false");
            case string words:
                return text == "\"" + words + "\"";
            default:
                return text == Convert.ToString(value, CultureInfo.InvariantCulture)
                    || (text == "default" && Convert.ToInt64(value, CultureInfo.InvariantCulture) == 0);
        }
    }

    private static bool IsImplied(MethodDefinition method) =>
        method.Name is ".cctor" or "Finalize" || (method.Name == ".ctor" && method.Parameters.Count == 0)
        || (method.IsVirtual && !method.IsNewSlot && method.Name is "Equals" or "GetHashCode" or "ToString")
        || method.Name.Contains('.');

    private static string KindOf(TypeDefinition type)
    {
        if (type.IsInterface)
            return "interface";
        if (type.IsEnum)
            return "enum";
        if (type.IsValueType)
            return "struct";
        return type.BaseType?.FullName == "System.MulticastDelegate" ? "delegate" : "class";
    }

    public static bool IsVisible(TypeDefinition type) => type.IsNested
        ? (type.IsNestedPublic || type.IsNestedFamily || type.IsNestedFamilyOrAssembly) && IsVisible(type.DeclaringType)
        : type.IsPublic;

    public static bool IsVisible(FieldAttributes attributes) =>
        (attributes & FieldAttributes.FieldAccessMask)
            is FieldAttributes.Public or FieldAttributes.Family or FieldAttributes.FamORAssem;
}
