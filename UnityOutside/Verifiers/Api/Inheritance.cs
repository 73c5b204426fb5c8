namespace UnityOutside.Api;

/// <summary>Whether a type keeps what it promised: Unity's interfaces that it implements, Unity's members that it
/// overrides.</summary>
internal sealed class Inheritance(UnityApi api, string generation)
{
    private readonly UnityApi m_api = api;
    private readonly string m_generation = generation;

    internal IEnumerable<string> Problems(TypeDefinition type)
    {
        string name = DocId.DefinitionName(type);
        if (type.IsInterface)
            yield break;
        foreach (TypeReference implemented in type.Interfaces.Select(i => i.InterfaceType))
        {
            if (!Origins.IsUnity(Origins.AssemblyOf(implemented)))
                continue;
            foreach (ApiRow member in m_api.Members(DocId.OfType(implemented), m_generation).Where(m => !m.IsInterfaceBody))
            {
                foreach (string accessor in Accessors(member, Arguments(implemented)))
                {
                    if (!Has(type, accessor, DocId.DefinitionName(implemented)))
                        yield return $"{name} does not implement {Shown(accessor)} of {DocId.DefinitionName(implemented)}";
                }
            }
        }
        foreach (string problem in Overrides(type, name))
            yield return problem;
    }

    private IEnumerable<string> Overrides(TypeDefinition type, string name)
    {
        TypeReference? unity = NearestUnityBase(type);
        if (unity == null)
            yield break;
        var inherited = new List<(string Text, ApiRow Row)>();
        for (ApiRow? at = m_api.Find(DocId.OfType(unity), m_generation); at != null;
            at = at.Type.Length == 0 ? null : m_api.Find("T:" + at.Type, m_generation))
        {
            foreach (ApiRow member in m_api.Members(at.Id, m_generation))
                inherited.AddRange(Accessors(member, Arguments(unity)).Select(a => (a, member)));
        }
        foreach (MethodDefinition method in type.Methods.Where(m => m.IsVirtual && !m.IsNewSlot))
        {
            string text = Signature(method, method.Name);
            if (s_ofObject.Contains(method.Name) || IsDeclaredBetween(type, method))
                continue;
            ApiRow? row = inherited.Where(i => i.Text == text).Select(i => i.Row).FirstOrDefault();
            if (row == null)
                yield return $"{name} overrides {Shown(text)}, which {DocId.DefinitionName(unity)} does not have";
            else if (!row.Has("virtual") && !row.Has("abstract") && !row.Has("override"))
                yield return $"{name} overrides {Shown(text)}, which is not virtual";
        }
        if (type.IsAbstract)
            yield break;
        foreach ((string text, ApiRow row) in inherited.Where(i => i.Row.Has("abstract")))
        {
            bool isMet = Has(type, text, "") || inherited.Any(i => i.Text == text && i.Row.Has("override"));
            if (!isMet)
                yield return $"{name} does not override {Shown(text)}, which is abstract in {DocId.DeclaringTypeOf(row.Id)}";
        }
    }

    private static readonly string[] s_ofObject = { "Equals", "GetHashCode", "ToString", "Finalize" };

    private static bool IsDeclaredBetween(TypeDefinition type, MethodDefinition method)
    {
        string text = Signature(method, method.Name);
        for (TypeDefinition? at = Own(type.BaseType); at != null; at = Own(at.BaseType))
        {
            if (at.Methods.Any(m => m.IsVirtual && m.IsNewSlot && Signature(m, m.Name) == text))
                return true;
        }
        return false;
    }

    private static TypeDefinition? Own(TypeReference? type) =>
        type == null || Origins.IsUnity(Origins.AssemblyOf(type)) ? null : Resolution.Of(type);

    private static TypeReference? NearestUnityBase(TypeDefinition type)
    {
        TypeReference? at = type.BaseType;
        while (at != null && !Origins.IsUnity(Origins.AssemblyOf(at)))
            at = Resolution.Of(at)?.BaseType;
        return at;
    }

    private static IEnumerable<string> Accessors(ApiRow member, IReadOnlyList<string> arguments)
    {
        string id = member.Id[(member.Id.IndexOf(DocId.DeclaringTypeOf(member.Id), StringComparison.Ordinal)
            + DocId.DeclaringTypeOf(member.Id).Length + 1)..];
        string type = member.Type + (member.Has("ref-return") || member.Has("ref-readonly-return") ? "@" : "");
        string Text(string signature) => DocId.Substitute(signature, arguments, new List<string>());
        switch (member.Kind)
        {
            case "method":
                yield return Text($"{type} {id}");
                break;
            case "property":
            case "indexer":
                if (member.Has("get"))
                    yield return Text($"{type} get_{id}");
                if (member.Has("set"))
                {
                    string index = id.IndexOf('(') is var at && at < 0 ? "(" : id[id.IndexOf('(')..^1] + ",";
                    yield return Text($"System.Void set_{(id.IndexOf('(') < 0 ? id : id[..id.IndexOf('(')])}{index}{type})");
                }
                break;
            case "event":
                yield return Text($"System.Void add_{id}({type})");
                yield return Text($"System.Void remove_{id}({type})");
                break;
        }
    }

    private static bool Has(TypeDefinition type, string signature, string interfaceName)
    {
        for (TypeDefinition? at = type; at != null; at = Own(at.BaseType))
        {
            foreach (MethodDefinition method in at.Methods)
            {
                if (Signature(method, method.Name) == signature)
                    return true;
                if (method.Overrides.Any(o => DocId.DefinitionName(o.DeclaringType) == interfaceName
                    && Signature(method, o.Name) == signature))
                    return true;
            }
        }
        return false;
    }

    private static string Signature(MethodDefinition method, string name) =>
        DocId.InSignature(method.ReturnType) + " " + name
        + (method.GenericParameters.Count > 0 ? "``" + method.GenericParameters.Count : "")
        + (method.Parameters.Count == 0 ? ""
            : "(" + string.Join(",", method.Parameters.Select(p => DocId.InSignature(p.ParameterType))) + ")");

    private static IReadOnlyList<string> Arguments(TypeReference type) => type is GenericInstanceType instance
        ? instance.GenericArguments.Select(DocId.InSignature).ToList()
        : new List<string>();

    private static string Shown(string signature) => signature[(signature.IndexOf(' ') + 1)..];
}
