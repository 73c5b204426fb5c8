namespace FastPoints.RepoTools.Hlsl;

/// <summary>The HLSL twin of a struct that lies in the raw buffer of a draw's lists, and what loads it from there: by words,
/// without gaps, and with nothing below 32 bits.</summary>
public static class HlslStructs
{
    public const string Attribute = "GenerateHlslAttribute";
    private const int LargestStride = 2048;
    private const string Prefix = "FastPoints", Lists = "../PointLists.hlsl";

    public static string Compose(TypeDefinition type)
    {
        FieldLayout layout = FieldLayout.Of(type);
        var lines = new List<(string Declaration, LaidOutField Field)>();
        int end = 0;
        foreach (LaidOutField field in layout.Fields)
        {
            if (field.Offset != end)
                throw new ToolException($"{type.FullName}.{field.Name} is at {field.Offset}, HLSL would have it at {end}");
            end = field.Offset + field.Size;
            string array = field.Count > 1 ? $"[{field.Count}]" : "";
            lines.Add(($"    {HlslType(field, type)} {field.Name}{array};", field));
        }
        if (layout.Size != end || end == 0 || end > LargestStride)
            throw new ToolException($"{type.FullName}: a stride of {layout.Size} bytes, HLSL would have {end}, " +
                $"at most {LargestStride}");

        int width = lines.Max(l => l.Declaration.Length);
        string guard = "FASTPOINTS_" + string.Concat(type.Name.Select((c, i) =>
            (i > 0 && char.IsUpper(c) ? "_" : "") + char.ToUpperInvariant(c))) + "_INCLUDED";
        var text = new StringBuilder();
        text.Append($"// Written by RepoTools hlsl from {type.FullName}: {layout.Size} bytes.\n");
        text.Append($"#ifndef {guard}\n#define {guard}\n\n#include \"{Lists}\"\n\nstruct {type.Name}\n{{\n");
        foreach ((string declaration, LaidOutField field) in lines)
            text.Append(declaration.PadRight(width)).Append($" // {field.Offset}, {field.Size}\n");
        text.Append($"}};\n\n// at: where it begins in the lists, in bytes.\n{type.Name} {Prefix}{type.Name}At(uint at)\n{{\n");
        text.Append($"    {type.Name} loaded;\n");
        foreach ((string declaration, LaidOutField field) in lines)
            for (int i = 0; i < field.Count; i++)
                text.Append(LoadOf(field, HlslType(field, type), i));
        text.Append("    return loaded;\n}\n\n#endif\n");
        return text.ToString();
    }

    private static string LoadOf(LaidOutField field, string type, int element)
    {
        string lanes = char.IsDigit(type[^1]) ? type[^1..] : "";
        int at = field.Offset + element * (field.Size / field.Count);
        string load = $"_FastPointsLists.Load{lanes}(at + {at}u)";
        string value = type.TrimEnd('2', '3', '4') switch { "float" => $"asfloat({load})", "int" => $"asint({load})", _ => load };
        return $"    loaded.{field.Name}{(field.Count > 1 ? $"[{element}]" : "")} = {value};\n";
    }

    private static string HlslType(LaidOutField field, TypeDefinition owner)
    {
        TypeReference type = field.Type;
        if (type.Resolve() is { IsEnum: true } enumeration)
            type = enumeration.Fields.First(f => !f.IsStatic).FieldType;
        switch (type.MetadataType)
        {
            case MetadataType.Int32:
                return "int";
            case MetadataType.UInt32:
                return "uint";
            case MetadataType.Single:
                return "float";
        }
        string name = type.Namespace == "Unity.Mathematics" ? type.Name : "";
        bool isVector = name.Length > 1 && name[^1] is '2' or '3' or '4' && (name[..^1] is "int" or "uint" or "float");
        if (isVector)
            return name;
        throw new ToolException($"{owner.FullName}.{field.Name}: no {type.FullName} in HLSL; " +
            "take int, uint, float, their vectors, or an enum of 32 bits");
    }
}
