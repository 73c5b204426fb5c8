namespace Unity.Mathematics;

internal static class Components
{
    [MethodImpl(Inline)]
    internal static int Checked(int index, int count)
    {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        if ((uint)index >= count)
            throw new ArgumentException($"index must be between[0...{count - 1}]");
#endif
        return index;
    }
}
