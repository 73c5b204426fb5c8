namespace Unity.Mathematics;

internal static class Inlining
{
    internal const MethodImplOptions Inline = MethodImplOptions.AggressiveInlining;
}
