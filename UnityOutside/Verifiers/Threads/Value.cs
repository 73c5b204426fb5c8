namespace UnityOutside.Threads;

/// <summary>What a variable may hold, as far as the IL shows: an object of a type that is known, a delegate of a method
/// that is known, or whatever the type of the variable allows.</summary>
/// <param name="Inner">What a delegate is bound to; the 'this' of the method that an iterator, an async method's state or
/// a lambda's variables were made in. Null if that is not known.</param>
internal sealed record Value(TypeReference Type, MethodDefinition Place, bool IsExact, MethodReference? Target = null,
    Value? Inner = null)
{
    internal static Value Made(TypeReference type, MethodDefinition place, Value? self)
    {
        var made = new Value(type, place, true);
        return made.IsOfMethod ? made with { Inner = self is { IsOfMethod: true } ? self.Inner : self } : made;
    }

    /// <summary>Tells one from another. What is bound counts: the same lambda may be made by two types.</summary>
    internal string Key => $"{(IsExact ? "" : "~")}{Type.FullName}>{Target?.FullName}>{Inner?.Key}";

    internal bool IsOfMethod => Type.Name.StartsWith('<');
}
