namespace UnityOutside.Api;

/// <summary>Documentation-comment ids of what IL names. A generic definition is named with its arity (<c>NativeArray`1</c>), a
/// generic type in a signature with its arguments, each level its own (<c>NativeArray{System.Int32}.ReadOnly</c>); the declaring
/// type's parameters are <c>`0</c>, the method's own <c>``0</c>; by-reference is <c>@</c> of whatever kind.</summary>
public static class DocId
{
    public static string OfType(TypeReference type) => "T:" + DefinitionName(type);

    public static string OfField(FieldReference field) => "F:" + DefinitionName(field.DeclaringType) + "." + field.Name;

    public static string OfMethod(MethodReference method) => OfMethod(DefinitionName(method.DeclaringType), method);

    public static string OfMethod(string declaringType, MethodReference method)
    {
        var id = new StringBuilder("M:").Append(declaringType).Append('.').Append(method.Name.Replace('.', '#'));
        if (method.GenericParameterCount() > 0)
            id.Append("``").Append(method.GenericParameterCount());
        Parameters(id, method.Parameters.Select(p => p.ParameterType));
        if (method.Name == "op_Implicit" || method.Name == "op_Explicit")
            id.Append('~').Append(InSignature(method.ReturnType));
        return id.ToString();
    }

    /// <summary>P: of the property whose accessor this is (get_ or set_), E: of the event (add_ or remove_); else null.</summary>
    public static string? OfAccessor(string declaringType, MethodReference method)
    {
        int underscore = method.Name.IndexOf('_');
        string prefix = underscore < 0 ? "" : method.Name[..underscore];
        string name = method.Name[(underscore + 1)..];
        IEnumerable<TypeReference> index = method.Parameters.Select(p => p.ParameterType);
        switch (prefix)
        {
            case "add":
            case "remove":
                return "E:" + declaringType + "." + name;
            case "get":
                break;
            case "set":
                index = index.Take(Math.Max(0, method.Parameters.Count - 1));
                break;
            default:
                return null;
        }
        var id = new StringBuilder("P:").Append(declaringType).Append('.').Append(name);
        Parameters(id, index);
        return id.ToString();
    }

    public static string InSignature(TypeReference type)
    {
        switch (type)
        {
            case GenericParameter parameter:
                return (parameter.Type == GenericParameterType.Method ? "``" : "`") + parameter.Position;
            case ByReferenceType reference:
                return InSignature(reference.ElementType) + "@";
            case PointerType pointer:
                return InSignature(pointer.ElementType) + "*";
            case ArrayType array:
                return InSignature(array.ElementType) + (array.IsVector ? "[]"
                    : "[" + string.Join(",", Enumerable.Repeat("0:", array.Rank)) + "]");
            case GenericInstanceType instance:
                return WithArguments(instance.ElementType, instance.GenericArguments.Select(InSignature).ToList());
            case FunctionPointerType function:
                return "=FUNC:" + InSignature(function.ReturnType) + "(" +
                    string.Join(",", function.Parameters.Select(p => InSignature(p.ParameterType))) + ")";
            case TypeSpecification wrapped:
                return InSignature(wrapped.ElementType);
            default:
                return DefinitionName(type);
        }
    }

    public static string DefinitionName(TypeReference type)
    {
        TypeReference element = type.GetElementType();
        if (element.DeclaringType != null)
            return DefinitionName(element.DeclaringType) + "." + element.Name;
        return string.IsNullOrEmpty(element.Namespace) ? element.Name : element.Namespace + "." + element.Name;
    }

    public static string DeclaringTypeOf(string memberId)
    {
        int end = memberId.IndexOf('(');
        if (end < 0)
            end = memberId.IndexOf('~');
        string name = end < 0 ? memberId : memberId[..end];
        return name[2..name.LastIndexOf('.')];
    }

    public static string Substitute(string signature, IReadOnlyList<string> typeArguments, IReadOnlyList<string> methodArguments)
    {
        var text = new StringBuilder();
        for (int i = 0; i < signature.Length; i++)
        {
            if (signature[i] != '`')
            {
                text.Append(signature[i]);
                continue;
            }
            bool isMethod = i + 1 < signature.Length && signature[i + 1] == '`';
            int digits = i + (isMethod ? 2 : 1);
            int end = digits;
            while (end < signature.Length && char.IsDigit(signature[end]))
                end++;
            int index = int.Parse(signature.AsSpan(digits, end - digits), null);
            IReadOnlyList<string> arguments = isMethod ? methodArguments : typeArguments;
            text.Append(index < arguments.Count ? arguments[index] : signature[i..end]);
            i = end - 1;
        }
        return text.ToString();
    }

    private static void Parameters(StringBuilder id, IEnumerable<TypeReference> types)
    {
        List<string> texts = types.Select(InSignature).ToList();
        if (texts.Count > 0)
            id.Append('(').AppendJoin(',', texts).Append(')');
    }

    private static string WithArguments(TypeReference type, List<string> arguments)
    {
        var levels = new List<TypeReference>();
        for (TypeReference? level = type; level != null; level = level.DeclaringType)
            levels.Insert(0, level);
        var text = new StringBuilder(string.IsNullOrEmpty(levels[0].Namespace) ? "" : levels[0].Namespace + ".");
        int taken = 0;
        for (int i = 0; i < levels.Count; i++)
        {
            if (i > 0)
                text.Append('.');
            string name = levels[i].Name;
            int tick = name.IndexOf('`');
            if (tick < 0)
            {
                text.Append(name);
                continue;
            }
            int arity = int.Parse(name.AsSpan(tick + 1), null);
            text.Append(name, 0, tick).Append('{').AppendJoin(',', arguments.Skip(taken).Take(arity)).Append('}');
            taken += arity;
        }
        return text.ToString();
    }

    private static int GenericParameterCount(this MethodReference method) => method is GenericInstanceMethod instance
        ? instance.GenericArguments.Count
        : method.GenericParameters.Count;
}
