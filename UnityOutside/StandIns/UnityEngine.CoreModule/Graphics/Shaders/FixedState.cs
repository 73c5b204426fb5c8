namespace StandIns.Graphics;

/// <summary>The fixed state of one draw, as Vulkan has it.</summary>
struct FixedState : IEquatable<FixedState>
{
    internal CullModeFlags Cull;
    internal CompareOp DepthTest;
    internal bool WritesDepth;
    internal BlendFactor SourceColor;
    internal BlendFactor TargetColor;
    internal BlendFactor SourceAlpha;
    internal BlendFactor TargetAlpha;
    internal BlendOp ColorOperation;
    internal BlendOp AlphaOperation;
    internal byte ColorMask;

    internal readonly bool Blends => SourceColor != BlendFactor.One || TargetColor != BlendFactor.Zero
        || SourceAlpha != BlendFactor.One || TargetAlpha != BlendFactor.Zero || ColorOperation != BlendOp.Add
        || AlphaOperation != BlendOp.Add;

    public readonly bool Equals(FixedState other) => Bits == other.Bits;
    public override readonly bool Equals(object obj) => obj is FixedState other && Equals(other);
    public override readonly int GetHashCode() => Bits.GetHashCode();

    // Cull 2 bits, test 3, write 1, factors 4 x 5, operations 2 x 3, mask 4.
    readonly ulong Bits => (uint)Cull | (ulong)DepthTest << 2 | (WritesDepth ? 1ul << 5 : 0) | (ulong)SourceColor << 6
        | (ulong)TargetColor << 11 | (ulong)SourceAlpha << 16 | (ulong)TargetAlpha << 21 | (ulong)ColorOperation << 26
        | (ulong)AlphaOperation << 29 | (ulong)ColorMask << 32;
}
