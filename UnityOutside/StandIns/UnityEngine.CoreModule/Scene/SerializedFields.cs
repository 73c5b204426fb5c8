namespace StandIns.Scene;

/// <summary>Which fields of an object Unity keeps: in scenes, in assets, in settings, over a reload.</summary>
static class SerializedFields
{
    const BindingFlags Declared =
        BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;

    /// <summary>Of a type and its bases up to Unity's own: those that are public, or say that they are to be kept.</summary>
    public static IEnumerable<FieldInfo> Of(Type type)
    {
        for (; type != null && type.Assembly != typeof(Object).Assembly; type = type.BaseType)
            foreach (var field in type.GetFields(Declared))
                if (IsMeantToBeKept(field))
                    yield return field;
    }

    /// <summary>Whether Unity keeps values of a type; of others it says nothing, and forgets them.</summary>
    public static bool IsKept(Type type)
    {
        if (type.IsArray)
            return type.GetArrayRank() == 1 && !IsMany(type.GetElementType()) && IsKept(type.GetElementType());
        if (IsMany(type))
            return !IsMany(type.GetGenericArguments()[0]) && IsKept(type.GetGenericArguments()[0]);
        if (type.IsEnum)
            return Enum.GetUnderlyingType(type) != typeof(long) && Enum.GetUnderlyingType(type) != typeof(ulong);
        if (type.IsPrimitive)
            return type != typeof(IntPtr) && type != typeof(UIntPtr);
        return type == typeof(string) || typeof(Object).IsAssignableFrom(type) ||
            IsUnitys(type) || IsMarked(type) && !type.IsAbstract && type.Namespace?.StartsWith(nameof(System)) != true;
    }

    /// <summary>As when an asset is imported again: who refers to the object before goes on doing so.</summary>
    public static void Copy(Object from, Object to)
    {
        foreach (var field in Kept(from))
            field.SetValue(to, field.GetValue(from));
    }

    /// <summary>The first field of which two objects have other values; null if there is none.</summary>
    public static string FindDifference(Object a, Object b) =>
        Kept(a).FirstOrDefault(f => !IsSame(f.GetValue(a), f.GetValue(b)))?.Name;

    static IEnumerable<FieldInfo> Kept(Object of) => Of(of.GetType()).Where(f => IsKept(f.FieldType));

    static bool IsSame(object a, object b) => a is Array x && b is Array y
        ? x.Cast<object>().SequenceEqual(y.Cast<object>())
        : Equals(a, b);

    static bool IsMeantToBeKept(FieldInfo field) => !field.IsInitOnly && !field.IsLiteral &&
        !field.IsDefined(typeof(NonSerializedAttribute), false) &&
        (field.IsPublic || field.IsDefined(typeof(SerializeField), false));

    static bool IsMany(Type type) => type.IsArray || type.IsGenericType && type.GetGenericTypeDefinition() == typeof(List<>);
    static bool IsMarked(Type type) => type.IsDefined(typeof(SerializableAttribute), false);
    static bool IsUnitys(Type type) => type.IsValueType && type.Namespace is nameof(UnityEngine) or "Unity.Mathematics";
}
