namespace UnityOutside.Threads;

/// <summary>What a variable may hold, as far as the IL shows: an object of a type that is known, a delegate of a method
/// that is known, or whatever the type of the variable allows.</summary>
/// <param name="Type">The object's type or, where that is not known, the variable's.</param>
/// <param name="Place">Whose type parameters may be in the type.</param>
/// <param name="IsExact">Whether it is that type and none that is derived from it.</param>
/// <param name="Target">The method of a delegate.</param>
/// <param name="Inner">What a delegate is bound to; the 'this' of the method that an iterator, an async method's state or
/// a lambda's variables were made in. Null where that is not known.</param>
internal sealed record Value(TypeReference Type, MethodDefinition Place, bool IsExact, MethodReference? Target = null,
    Value? Inner = null)
{
    /// <summary>An object that a method makes.</summary>
    /// <param name="self">What the method works on, where that is known.</param>
    internal static Value Made(TypeReference type, MethodDefinition place, Value? self)
    {
        var made = new Value(type, place, true);
        return made.IsOfMethod ? made with { Inner = self is { IsOfMethod: true } ? self.Inner : self } : made;
    }

    /// <summary>Tells one from another. What is bound counts: the same lambda may be made by two types.</summary>
    internal string Key => $"{(IsExact ? "" : "~")}{Type.FullName}>{Target?.FullName}>{Inner?.Key}";

    /// <summary>A type of the compiler's that stands for a method's variables.</summary>
    internal bool IsOfMethod => Type.Name.StartsWith('<');
}
