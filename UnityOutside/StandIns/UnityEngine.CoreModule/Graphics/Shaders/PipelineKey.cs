namespace StandIns.Graphics;

readonly struct PipelineKey : IEquatable<PipelineKey>
{
    internal readonly FixedState State;
    internal readonly PrimitiveTopology Topology;
    internal readonly Format Depth;
    internal readonly int ColorCount;
    readonly ulong m_colors; // 16 bits a target.

    internal PipelineKey(RenderTargets targets, in FixedState state, PrimitiveTopology topology)
    {
        State = state;
        Topology = topology;
        Depth = targets.DepthFormat;
        ColorCount = targets.ColorCount;
        m_colors = 0;
        for (int i = 0; i < ColorCount; i++)
            m_colors |= (ulong)targets.ColorFormat(i) << (16 * i);
    }

    internal Format Color(int index) => (Format)(m_colors >> (16 * index) & 0xffff);

    public bool Equals(PipelineKey other) => State.Equals(other.State) && Topology == other.Topology && Depth == other.Depth
        && ColorCount == other.ColorCount && m_colors == other.m_colors;

    public override bool Equals(object obj) => obj is PipelineKey other && Equals(other);
    public override int GetHashCode() => HashCode.Combine(State, (int)Topology, (int)Depth, ColorCount, m_colors);
}
