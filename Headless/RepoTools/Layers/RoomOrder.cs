namespace FastPoints.RepoTools.Layers;

public static class RoomOrder
{
    private static readonly (string Assembly, string[] Rooms)[] s_order =
    {
        ("FastPoints", new[] { "Core", "Store", "Streaming", "Drawing", "Queries" }),
        ("FastPoints.Import", new[]
        {
            "Reading", "Las", "Laz", "E57", "Text", "Sampling", "Nodes", "Sources", "Build", "Export",
        }),
        ("FastPoints.Picture", new[] { "Picture" }),
        ("FastPoints.Surface", new[] { "Surface" }),
    };

    public static IEnumerable<string> Assemblies => s_order.Select(o => o.Assembly);

    /// <summary>The index of a room in the order; -1 if there is no such room.</summary>
    public static int IndexOf(string assembly, string room)
    {
        int before = 0;
        foreach ((string name, string[] rooms) in s_order)
        {
            int index = Array.IndexOf(rooms, room);
            if (name == assembly)
                return index < 0 ? -1 : before + index;
            before += rooms.Length;
        }
        return -1;
    }

    public static IEnumerable<string> CheckSources(string folder, string assembly)
    {
        foreach (string file in Directory.EnumerateFiles(folder, "*.cs", SearchOption.AllDirectories))
        {
            string path = Path.GetRelativePath(folder, file).Replace('\\', '/');
            foreach (string problem in CheckSource(assembly, path, File.ReadAllText(file)))
                yield return problem;
        }
    }

    public static IEnumerable<string> CheckSource(string assembly, string path, string text)
    {
        string shown = $"{assembly}/{path}";
        if (path == "AssemblyInfo.cs")
            yield break;
        string room = path.Contains('/') ? path[..path.IndexOf('/')] : assembly[(assembly.LastIndexOf('.') + 1)..];
        int own = IndexOf(assembly, room);
        if (own < 0)
        {
            yield return $"{shown}: {assembly} has no room {room}";
            yield break;
        }
        string code = WithoutCommentsAndStrings(text);
        foreach (Match declared in Regex.Matches(code, @"^\s*namespace\s+([\w.]+)", RegexOptions.Multiline))
        {
            if (declared.Groups[1].Value != NamespaceOf(room))
                yield return $"{shown}: namespace {declared.Groups[1].Value}, wanted {NamespaceOf(room)}";
        }
        foreach (string used in Regex.Matches(code, @"\bFastPoints\.(\w+)").Select(m => m.Groups[1].Value).Distinct())
        {
            int index = s_order.Max(o => IndexOf(o.Assembly, used));
            if (index > own)
                yield return $"{shown} uses FastPoints.{used}, which comes after {room}";
        }
    }

    // The core needs no using: its namespace contains all rooms.
    private static string NamespaceOf(string room) => room == "Core" ? "FastPoints" : "FastPoints." + room;

    public static IEnumerable<string> CheckIl(ModuleDefinition module)
    {
        string assembly = module.Assembly.Name.Name;
        var problems = new SortedSet<string>(StringComparer.Ordinal);
        foreach (IlUse use in IlUses.Of(module).Where(u => u.Within != null))
        {
            string room = RoomOf(use.Within!);
            int own = IndexOf(assembly, room);
            foreach (TypeReference named in Types(use.Member))
            {
                int other = IndexOf(Origins.AssemblyOf(named), RoomOf(named));
                if (own >= 0 && other > own)
                    problems.Add($"{use.Site} ({room}) names {DocId.DefinitionName(named)}, which comes after {room}");
            }
        }
        return problems;
    }

    internal static IEnumerable<TypeReference> Types(MemberReference member)
    {
        IEnumerable<TypeReference> types = member switch
        {
            MethodReference method => method.Parameters.Select(p => p.ParameterType).Append(method.ReturnType)
                .Append(method.DeclaringType)
                .Concat(method is GenericInstanceMethod generic ? generic.GenericArguments : Enumerable.Empty<TypeReference>()),
            FieldReference field => new[] { field.FieldType, field.DeclaringType },
            TypeReference type => new[] { type },
            _ => Enumerable.Empty<TypeReference>(),
        };
        return types.SelectMany(Elements);
    }

    private static IEnumerable<TypeReference> Elements(TypeReference type) => type switch
    {
        GenericParameter or FunctionPointerType => Enumerable.Empty<TypeReference>(),
        GenericInstanceType instance => instance.GenericArguments.SelectMany(Elements).Append(instance.ElementType),
        TypeSpecification wrapped => Elements(wrapped.ElementType),
        _ => new[] { type },
    };

    private static string RoomOf(TypeReference type)
    {
        TypeReference outer = type.GetElementType();
        while (outer.DeclaringType != null)
            outer = outer.DeclaringType;
        string[] parts = outer.Namespace.Split('.');
        return parts[0] != "FastPoints" ? "" : parts.Length > 1 ? parts[1] : "Core";
    }

    private static string WithoutCommentsAndStrings(string text) =>
        Regex.Replace(text, @"//[^\n]*|/\*.*?\*/|@?""(?:[^""\\\n]|\\.)*""", " ", RegexOptions.Singleline);
}
