namespace FastPoints.RepoTools.Reference;

public static class Signature
{
    private static readonly Dictionary<string, string> s_keywords = new Dictionary<string, string>
    {
        ["System.Void"] = "void",
        ["System.Object"] = "object",
        ["System.String"] = "string",
        ["System.Boolean"] = "bool",
        ["System.Char"] = "char",
        ["System.SByte"] = "sbyte",
        ["System.Byte"] = "byte",
        ["System.Int16"] = "short",
        ["System.UInt16"] = "ushort",
        ["System.Int32"] = "int",
        ["System.UInt32"] = "uint",
        ["System.Int64"] = "long",
        ["System.UInt64"] = "ulong",
        ["System.Single"] = "float",
        ["System.Double"] = "double",
    };

    public static string Of(MethodDefinition method)
    {
        string parameters = string.Join(", ", method.Parameters.Select(Parameter));
        if (method.IsConstructor)
            return $"new {Name(method.DeclaringType)}({parameters})";
        string generic = method.HasGenericParameters
            ? $"<{string.Join(", ", method.GenericParameters.Select(p => p.Name))}>"
            : "";
        return $"{Modifier(method)}{Name(method.ReturnType)} {method.Name}{generic}({parameters})";
    }

    public static string Of(PropertyDefinition property) =>
        $"{Modifier(property.GetMethod)}{Name(property.PropertyType)} " + (property.HasParameters
            ? $"this[{string.Join(", ", property.Parameters.Select(Parameter))}]"
            : property.Name);

    public static string Of(FieldDefinition field) =>
        (field.HasConstant ? "const " : field.IsStatic ? "static " : "") + $"{Name(field.FieldType)} {field.Name}";

    public static bool Makes(MethodDefinition method, TypeDefinition type) =>
        method.ReturnType.FullName == type.FullName ||
        !(type.IsAbstract && type.IsSealed) && Name(method.ReturnType) == "IEnumerator<Work>";

    public static string Name(TypeReference type) => type switch
    {
        RequiredModifierType modified => Name(modified.ElementType),
        ByReferenceType byReference => Name(byReference.ElementType),
        ArrayType array => Name(array.ElementType) + "[]",
        PointerType pointer => Name(pointer.ElementType) + "*",
        GenericInstanceType { ElementType: { FullName: "System.Nullable`1" } } nullable =>
            Name(nullable.GenericArguments[0]) + "?",
        GenericInstanceType generic =>
            $"{Plain(generic.ElementType)}<{string.Join(", ", generic.GenericArguments.Select(Name))}>",
        TypeDefinition { HasGenericParameters: true } open =>
            $"{Plain(open)}<{string.Join(", ", open.GenericParameters.Select(p => p.Name))}>",
        _ => s_keywords.GetValueOrDefault(type.FullName) ?? Plain(type),
    };

    private static string Plain(TypeReference type)
    {
        string name = type.Name.Split('`')[0];
        return type.DeclaringType == null || type.IsGenericParameter ? name : $"{Plain(type.DeclaringType)}.{name}";
    }

    private static string Modifier(MethodDefinition method) => method.IsStatic ? "static " : method.IsAbstract ? "abstract " : "";

    private static string Parameter(ParameterDefinition parameter)
    {
        string kind = Has(parameter, "ParamArrayAttribute") ? "params "
            : !parameter.ParameterType.IsByReference ? ""
            : parameter.IsOut ? "out " : Has(parameter, "IsReadOnlyAttribute") ? "in " : "ref ";
        string value = parameter.HasConstant ? $" = {Value(parameter)}" : "";
        return $"{kind}{Name(parameter.ParameterType)} {parameter.Name}{value}";
    }

    private static bool Has(ParameterDefinition parameter, string attribute) =>
        parameter.CustomAttributes.Any(a => a.AttributeType.Name == attribute);

    private static string Value(ParameterDefinition parameter) => parameter.Constant switch
    {
        null => parameter.ParameterType.IsValueType ? "default" : "null",
        bool truth => truth ? "true" : "false",
        string text => $"\"{text}\"",
        IFormattable number => parameter.ParameterType.Resolve() is { IsEnum: true } values
            ? $"{values.Name}.{values.Fields.First(f => f.HasConstant && Equals(f.Constant, number)).Name}"
            : number.ToString(null, CultureInfo.InvariantCulture),
        object other => other.ToString()!,
    };
}
