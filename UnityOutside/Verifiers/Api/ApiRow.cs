namespace UnityOutside.Api;

/// <summary>One line of a list of Unity's signatures: the columns as they stand, and as they were in one generation. The list's
/// README says what each column holds.</summary>
public sealed record ApiRow(
    string Id, string Assembly, string Kind, string Type, string Flags, string Detail, string Constraints,
    string Obsolete, string In, string Varied)
{
    private const string HdrpGeneration = "6000.4";

    public const string Header = "#id\tassembly\tkind\ttype\tflags\tdetail\tconstraints\tobsolete\tin\tvaried";

    public bool IsType => Id.StartsWith("T:", StringComparison.Ordinal);
    public bool IsStatic => Has("static") || Kind == "const" || Kind == "enumvalue";
    public bool IsInterfaceBody => Has("default-impl");

    public static ApiRow Parse(string line)
    {
        string[] c = line.Split('\t');
        string At(int i) => i < c.Length ? c[i] : "";
        return new ApiRow(c[0], At(1), At(2), At(3), At(4), At(5), At(6), At(7), At(8), At(9));
    }

    public string Compose() => string.Join('\t', Id, Assembly, Kind, Type, Flags, Detail, Constraints, Obsolete, In, Varied)
        .TrimEnd('\t');

    /// <summary>HDRP's signatures are known of 6000.0 and 6000.4, and of little of 6000.3: its other generations are taken
    /// for 6000.4's.</summary>
    public bool IsIn(string generation) => In == "*" || In.Split(',').Contains(generation)
        || (generation != "6000.0" && In.Split(',').Contains(HdrpGeneration));

    public bool Has(string flag)
    {
        int value = Flags.IndexOf('=');
        string flags = value < 0 ? Flags : Flags[..value];
        return flags.Split(',').Contains(flag);
    }

    public string? Value => Flags.IndexOf('=') is var at && at >= 0 ? Flags[(at + 1)..] : null;

    public bool IsError(string generation)
    {
        foreach (string state in Obsolete.Split(',', StringSplitOptions.RemoveEmptyEntries))
        {
            string[] parts = state.Split('@');
            bool began = parts.Length == 1 || string.CompareOrdinal(parts[1], generation) <= 0;
            if (parts[0] == "error" && began)
                return true;
        }
        return false;
    }

    public ApiRow As(string generation)
    {
        ApiRow row = this;
        for (int at = 0; at < Varied.Length;)
        {
            int open = Varied.IndexOf('{', at);
            if (open < 0)
                break;
            int close = Closing(Varied, open);
            string column = Varied[at..open].Trim(' ', ',', ';');
            foreach (string variant in Varied[(open + 1)..close].Split(" | "))
            {
                if (variant.StartsWith(generation + ":", StringComparison.Ordinal))
                    row = row.With(column, variant[(generation.Length + 1)..]);
            }
            at = close + 1;
        }
        return row;
    }

    private ApiRow With(string column, string value) => column switch
    {
        "type" => this with { Type = value },
        "flags" => this with { Flags = value },
        "detail" => this with { Detail = value },
        "constraints" => this with { Constraints = value },
        "assembly" => this with { Assembly = value },
        "kind" => this with { Kind = value },
        _ => this,
    };

    /// <summary>A member's parameters: the by-reference kind ("", ref, out, in) and whether the caller may leave it
    /// out.</summary>
    public IReadOnlyList<ApiParameter> Parameters()
    {
        var parameters = new List<ApiParameter>();
        foreach (string part in SplitOutsideQuotes(Detail))
        {
            string text = part.Trim();
            int equals = text.IndexOf('=');
            string? fallback = equals < 0 ? null : text[(equals + 1)..];
            string[] words = (equals < 0 ? text : text[..equals]).Split(' ');
            string kind = words.FirstOrDefault(w => w == "ref" || w == "out" || w == "in") ?? "";
            parameters.Add(new ApiParameter(words[^1], kind, fallback));
        }
        return parameters;
    }

    private static IEnumerable<string> SplitOutsideQuotes(string detail)
    {
        if (detail.Length == 0)
            yield break;
        int start = 0;
        bool quoted = false;
        for (int i = 0; i < detail.Length; i++)
        {
            if (detail[i] == '"')
                quoted = !quoted;
            if (detail[i] != ',' || quoted)
                continue;
            yield return detail[start..i];
            start = i + 1;
        }
        yield return detail[start..];
    }

    private static int Closing(string text, int open)
    {
        int depth = 0;
        for (int i = open; i < text.Length; i++)
        {
            if (text[i] == '{')
                depth++;
            if (text[i] == '}' && --depth == 0)
                return i;
        }
        return text.Length;
    }
}

/// <summary>A parameter as the list shows it: Kind is "", ref, out or in; Default is null where the caller must give
/// it.</summary>
public sealed record ApiParameter(string Name, string Kind, string? Default);
