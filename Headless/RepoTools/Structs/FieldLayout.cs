namespace FastPoints.RepoTools.Structs;

public sealed record LaidOutField(string Name, TypeReference Type, int Count, int Offset, int Size);

public sealed class FieldLayout
{
    private FieldLayout(IReadOnlyList<LaidOutField> fields, int size, int alignment) =>
        (Fields, Size, Alignment) = (fields, size, alignment);

    public IReadOnlyList<LaidOutField> Fields { get; }
    public int Size { get; }
    public int Alignment { get; }

    public static FieldLayout Of(TypeDefinition type)
    {
        if (!type.IsSequentialLayout && !type.IsExplicitLayout)
            throw new ToolException($"{type.FullName}: its layout is neither sequential nor explicit");
        int pack = type.PackingSize > 0 ? type.PackingSize : 8;
        int end = 0;
        int alignment = 1;
        var fields = new List<LaidOutField>();
        foreach (FieldDefinition field in type.Fields.Where(f => !f.IsStatic))
        {
            (int size, int align, int count, TypeReference element) = Measure(field);
            align = Math.Min(align, pack);
            int offset = type.IsExplicitLayout ? field.Offset : (end + align - 1) / align * align;
            fields.Add(new LaidOutField(field.Name, element, count, offset, size));
            end = Math.Max(end, offset + size);
            alignment = Math.Max(alignment, align);
        }
        int total = (end + alignment - 1) / alignment * alignment;
        return new FieldLayout(fields, Math.Max(total, type.ClassSize), alignment);
    }

    public static IEnumerable<TypeDefinition> Marked(IEnumerable<ModuleDefinition> modules, string attribute) =>
        modules.SelectMany(m => m.GetTypes()).Where(t => t.IsValueType && !t.IsEnum
            && t.CustomAttributes.Any(a => a.AttributeType.Name == attribute));

    private static (int Size, int Align, int Count, TypeReference Element) Measure(FieldDefinition field)
    {
        CustomAttribute? buffer = field.CustomAttributes.FirstOrDefault(a => a.AttributeType.Name == "FixedBufferAttribute");
        if (buffer != null)
        {
            var element = (TypeReference)buffer.ConstructorArguments[0].Value;
            int count = (int)buffer.ConstructorArguments[1].Value;
            (int one, int elementAlign) = Measure(element, field);
            return (one * count, elementAlign, count, element);
        }
        (int size, int align) = Measure(field.FieldType, field);
        return (size, align, 1, field.FieldType);
    }

    private static (int Size, int Align) Measure(TypeReference type, FieldDefinition field)
    {
        switch (type.MetadataType)
        {
            case MetadataType.Boolean:
            case MetadataType.Byte:
            case MetadataType.SByte:
                return (1, 1);
            case MetadataType.Int16:
            case MetadataType.UInt16:
                return (2, 2);
            case MetadataType.Int32:
            case MetadataType.UInt32:
            case MetadataType.Single:
                return (4, 4);
            case MetadataType.Int64:
            case MetadataType.UInt64:
            case MetadataType.Double:
                return (8, 8);
        }
        TypeDefinition? definition = type.IsValueType ? type.Resolve() : null;
        if (definition == null)
            throw new ToolException($"{field.FullName}: a {type.FullName} has no fixed bytes");
        if (definition.IsEnum)
            return Measure(definition.Fields.First(f => !f.IsStatic).FieldType, field);
        FieldLayout layout = Of(definition);
        return (layout.Size, layout.Alignment);
    }
}
