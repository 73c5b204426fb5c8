namespace Unity.Mathematics;

internal static class Inlining
{
    internal const MethodImplOptions Always = MethodImplOptions.AggressiveInlining;
}
