namespace StandIns.Graphics;

readonly unsafe struct GpuAllocation(GpuMemoryBlock block, ulong offset, ulong bytes)
{
    internal readonly GpuMemoryBlock Block = block;
    internal readonly ulong Offset = offset;
    internal readonly ulong Bytes = bytes;

    internal bool IsCreated => Block != null;
    internal byte* Mapped => Block.Mapped == null ? null : Block.Mapped + Offset; // Where the host sees it; null if it does not.
}
