using FastPoints.Points;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Files
{
    /// <summary>A slot of <see cref="PlyListReader"/>.</summary>
    sealed class PlyListRead : PlyRead
    {
        readonly PlyListReader m_reader;
        NativeArray<PlyStep> m_steps;

        public PlyListRead(PlyListReader reader, PointSchema wanted, int capacity, Allocator allocator)
            : base(reader, wanted, capacity, reader.MaxBlockBytes, allocator)
        {
            m_reader = reader;
            m_steps = ToNative(reader.Steps(Points), allocator);
        }

        protected override JobHandle Schedule(BlockRange range)
        {
            var block = m_reader.Block(range.Block);
            var read = File.Begin(block.OffsetBytes, block.Bytes);
            return new DecodePlyListsJob
            {
                Input = File.Buffer,
                InputOffset = block.OffsetBytes,
                InputBytes = File.Bytes,
                Steps = m_steps,
                FirstPoint = range.First,
                Points = range.Count,
                IsBigEndian = m_reader.IsBigEndian,
                Output = Points.Bytes,
                Result = Result,
            }.Schedule(read);
        }

        protected override void DisposeTables() => m_steps.Dispose();
    }
}
