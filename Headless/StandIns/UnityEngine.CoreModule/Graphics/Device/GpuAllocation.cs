namespace StandIns.Graphics
{
    /// <summary>A part of a block of device memory.</summary>
    readonly unsafe struct GpuAllocation
    {
        internal readonly GpuMemoryBlock Block;
        internal readonly ulong Offset;
        internal readonly ulong Bytes;

        internal GpuAllocation(GpuMemoryBlock block, ulong offset, ulong bytes)
        {
            Block = block;
            Offset = offset;
            Bytes = bytes;
        }

        internal bool IsCreated => Block != null;

        /// <summary>Where the host sees it; null where it does not.</summary>
        internal byte* Mapped => Block.Mapped == null ? null : Block.Mapped + Offset;
    }
}
