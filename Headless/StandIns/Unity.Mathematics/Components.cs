using System.Diagnostics;

namespace Unity.Mathematics;

internal static class Components
{
    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    internal static void Check(int index, int count)
    {
        if ((uint)index >= count)
            throw new ArgumentException($"index must be between[0...{count - 1}]");
    }
}
