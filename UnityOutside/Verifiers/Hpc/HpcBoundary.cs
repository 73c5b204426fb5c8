namespace UnityOutside.Hpc;

/// <summary>What compiled code may call outside the package. Of .NET: what Burst's manual lists (System namespace support, types
/// and spans); of Unity: mathematics, containers, memory and Burst itself, but not what belongs to the main thread.</summary>
internal static class HpcBoundary
{
    private static readonly string[] s_systemTypes =
    {
        "System.Math", "System.IntPtr", "System.UIntPtr", "System.Threading.Interlocked", "System.Span`1",
        "System.ReadOnlySpan`1",
    };

    private static readonly string[] s_systemMethods =
    {
        "System.BitConverter.DoubleToInt64Bits", "System.BitConverter.Int64BitsToDouble",
        "System.BitConverter.SingleToInt32Bits", "System.BitConverter.Int32BitsToSingle",
        "System.ValueTuple.Create",
        "System.Guid..ctor", "System.Guid.Equals", "System.Guid.CompareTo", "System.Guid.GetHashCode",
        "System.Guid.op_Equality", "System.Guid.op_Inequality",
        "System.Threading.Thread.MemoryBarrier", "System.Threading.Volatile.Read", "System.Threading.Volatile.Write",
        "System.Single.IsNaN", "System.Single.IsInfinity", "System.Single.IsFinite", "System.Single.IsNegative",
        "System.Single.IsNegativeInfinity", "System.Single.IsPositiveInfinity",
        "System.Double.IsNaN", "System.Double.IsInfinity", "System.Double.IsFinite", "System.Double.IsNegative",
        "System.Double.IsNegativeInfinity", "System.Double.IsPositiveInfinity",
    };

    private static readonly string[] s_ofNumbers = { "CompareTo", "Equals", "GetHashCode" };

    private static readonly string[] s_unityNamespaces =
    {
        "Unity.Mathematics", "Unity.Collections", "Unity.Burst", "Unity.Profiling", "Unity.Jobs.LowLevel.Unsafe",
    };

    // Of Entities' structs those that jobs are made for; EntityManager and queries are the main thread's.
    private static readonly string[] s_entityTypes = { "Unity.Entities.Entity" };

    /// <summary>Whether a literal may be given to that method: Burst makes its bytes a constant.</summary>
    internal static bool TakesLiterals(MethodReference method)
    {
        string type = method.DeclaringType.FullName;
        return type.StartsWith("Unity.Collections.FixedString", StringComparison.Ordinal)
            || type == "Unity.Profiling.ProfilerMarker" || IsLog(method);
    }

    internal static string? Objection(MethodReference method, GenericScope scope)
    {
        TypeReference type = method.DeclaringType.GetElementType();
        string name = $"{type.FullName}.{method.Name}";
        if (!Origins.IsUnity(Origins.AssemblyOf(type)))
            return IsSystem(method, type, name) ? Parts(method, scope, name) : $"calls {name}, which Burst does not know";
        if (IsLog(method))
            return null;
        TypeReference outer = type;
        while (outer.DeclaringType != null)
            outer = outer.DeclaringType;
        bool isOpen = name == "Unity.Physics.MeshCollider.Create" || s_unityNamespaces.Any(n => outer.Namespace == n
            || outer.Namespace.StartsWith(n + ".", StringComparison.Ordinal));
        bool isValue = type.IsValueType && (outer.Namespace == "UnityEngine" || s_entityTypes.Contains(outer.FullName));
        if (!isOpen && !isValue)
            return $"calls {name}, which is not for jobs";
        return TakesLiterals(method) ? null : Parts(method, scope, name);
    }

    private static string? Parts(MethodReference method, GenericScope scope, string name)
    {
        foreach (TypeReference part in method.Parameters.Select(p => p.ParameterType).Append(method.ReturnType))
        {
            if (HpcTypes.Objection(scope.Concrete(part)) is { } objection)
                return $"calls {name} with {objection}";
        }
        return null;
    }

    private static bool IsSystem(MethodReference method, TypeReference type, string name)
    {
        if (type.FullName == "System.Threading.Volatile" && method is GenericInstanceMethod)
            return false;
        // The manual of early versions of 1.8 excepts both.
        if (name == "System.Math.IEEERemainder" || (name == "System.Math.Round" && TakesDigits(method)))
            return false;
        return s_systemTypes.Contains(type.FullName) || s_systemMethods.Contains(name)
            || type.FullName.StartsWith("System.ValueTuple`", StringComparison.Ordinal)
            || (type.IsPrimitive && s_ofNumbers.Contains(method.Name) && method.Parameters.All(p => p.ParameterType.IsValueType))
            || (type.FullName == "System.IDisposable" && method.Name == "Dispose");
    }

    private static bool TakesDigits(MethodReference round) =>
        round.Parameters.Count > 1 && round.Parameters[1].ParameterType.MetadataType == MetadataType.Int32;

    private static bool IsLog(MethodReference method) =>
        method.DeclaringType.FullName == "UnityEngine.Debug" && method.Name.StartsWith("Log", StringComparison.Ordinal);
}
