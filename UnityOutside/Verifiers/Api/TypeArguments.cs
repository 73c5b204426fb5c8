namespace UnityOutside.Api;

internal sealed class TypeArguments(UnityApi api, string generation)
{
    private readonly UnityApi m_api = api;
    private readonly string m_generation = generation;

    internal IEnumerable<string> Misfits(string constraints, IReadOnlyList<TypeReference> arguments,
        IReadOnlyList<TypeReference> typeArguments, IReadOnlyList<TypeReference> methodArguments)
    {
        string[] parameters = constraints.Split("; ");
        if (constraints.Length == 0 || parameters.Length != arguments.Count)
            yield break;
        List<string> typeTexts = typeArguments.Select(DocId.InSignature).ToList();
        List<string> methodTexts = methodArguments.Select(DocId.InSignature).ToList();
        for (int i = 0; i < parameters.Length; i++)
        {
            int colon = parameters[i].IndexOf(':');
            if (colon < 0)
                continue;
            foreach (string wanted in parameters[i][(colon + 1)..].Split('&'))
            {
                string constraint = DocId.Substitute(wanted, typeTexts, methodTexts);
                if (!Fits(arguments[i], constraint))
                    yield return $"{parameters[i][..colon]} = {DocId.InSignature(arguments[i])} is not {constraint}";
            }
        }
    }

    private bool Fits(TypeReference argument, string constraint)
    {
        // In the signature of Unity's own member its parameters stand for themselves.
        if (argument is GenericParameter { Owner: not (TypeDefinition or MethodDefinition) })
            return true;
        return constraint switch
        {
            "struct" => IsValue(argument),
            "unmanaged" => IsUnmanaged(argument),
            "class" => !IsValue(argument),
            "new()" or "notnull" => true,
            _ => Implements(argument, constraint),
        };
    }

    private static bool IsValue(TypeReference argument) => argument switch
    {
        GenericParameter parameter => parameter.HasNotNullableValueTypeConstraint,
        PointerType or ArrayType => false,
        _ => argument.IsValueType && argument.GetElementType().FullName != "System.Nullable`1",
    };

    private bool IsUnmanaged(TypeReference argument)
    {
        switch (argument)
        {
            case GenericParameter parameter:
                return parameter.Constraints.Any(c => c.ConstraintType is RequiredModifierType)
                    || parameter.CustomAttributes.Any(a => a.AttributeType.Name == "IsUnmanagedAttribute");
            case PointerType:
                return true;
        }
        if (!IsValue(argument))
            return false;
        if (argument.IsPrimitive)
            return true;
        if (argument is GenericInstanceType instance && !instance.GenericArguments.All(IsUnmanaged))
            return false;
        if (Origins.IsUnity(Origins.AssemblyOf(argument)))
            return m_api.Find(DocId.OfType(argument), m_generation) is not { } row || !row.Has("managed");
        TypeDefinition? definition = Resolution.Of(argument);
        return definition == null || definition.Fields.Where(f => !f.IsStatic)
            .All(f => f.FieldType is GenericParameter || f.FieldType.IsPrimitive || IsUnmanaged(f.FieldType));
    }

    private bool Implements(TypeReference argument, string wanted)
    {
        if (DocId.InSignature(argument) == wanted)
            return true;
        if (argument is GenericParameter parameter)
            return parameter.Constraints.Any(c => Implements(c.ConstraintType, wanted));
        if (Origins.IsUnity(Origins.AssemblyOf(argument)))
            return UnityImplements(DocId.OfType(argument), Arguments(argument), wanted);
        TypeDefinition? definition = Resolution.Of(argument);
        if (definition == null)
            return !Origins.IsUnity(wanted);
        List<string> arguments = Arguments(argument);
        foreach (TypeReference implemented in definition.Interfaces.Select(i => i.InterfaceType))
        {
            if (DocId.Substitute(DocId.InSignature(implemented), arguments, new List<string>()) == wanted)
                return true;
        }
        return definition.BaseType != null && Implements(definition.BaseType, wanted);
    }

    private bool UnityImplements(string typeId, List<string> arguments, string wanted)
    {
        ApiRow? row = m_api.Find(typeId, m_generation);
        if (row == null)
            return false;
        IEnumerable<string> implemented = SplitTypes(row.Detail);
        if (row.Kind == "class")
            implemented = implemented.Append(row.Type);
        foreach (string text in implemented.Select(t => DocId.Substitute(t, arguments, new List<string>())))
        {
            if (text == wanted || (text.StartsWith("Unity", System.StringComparison.Ordinal) && UnityImplements(text, wanted)))
                return true;
        }
        return false;
    }

    private bool UnityImplements(string signature, string wanted)
    {
        int brace = signature.IndexOf('{');
        if (brace < 0)
            return UnityImplements("T:" + signature, new List<string>(), wanted);
        List<string> arguments = SplitTypes(signature[(brace + 1)..^1]).ToList();
        return UnityImplements($"T:{signature[..brace]}`{arguments.Count}", arguments, wanted);
    }

    internal static IEnumerable<string> SplitTypes(string detail)
    {
        int depth = 0;
        int start = 0;
        for (int i = 0; i < detail.Length; i++)
        {
            if (detail[i] == '{')
                depth++;
            if (detail[i] == '}')
                depth--;
            if (detail[i] != ',' || depth > 0)
                continue;
            yield return detail[start..i].Trim();
            start = i + 1;
        }
        if (start < detail.Length)
            yield return detail[start..].Trim();
    }

    private static List<string> Arguments(TypeReference type) => type is GenericInstanceType instance
        ? instance.GenericArguments.Select(DocId.InSignature).ToList()
        : new List<string>();
}
