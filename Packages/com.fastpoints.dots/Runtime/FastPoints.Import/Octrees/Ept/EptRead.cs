using FastPoints.Core;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Octrees
{
    abstract class EptRead : SlotRead
    {
        readonly NativeFileRead m_file;

        protected EptRead(PointReader reader, EptBlocks blocks, PointSchema wanted, int capacity, Allocator allocator)
            : base(reader, wanted, capacity, allocator)
        {
            Blocks = blocks;
            m_file = new NativeFileRead(0, allocator);
        }

        protected EptBlocks Blocks { get; }

        // With the padding that was requested.
        protected NativeArray<byte> Input => m_file.Buffer;

        protected abstract JobHandle Schedule(BlockRange range, in EptBlock block);

        protected virtual void WarnBroken(DecodeResult result) { }

        protected sealed override JobHandle Schedule(BlockRange range)
        {
            var block = Blocks[range.Block];
            bool isBehindEnd = block.FirstInNode > 0 && block.FirstInNode + range.First >= Blocks.EndOfNode(block);
            return isBehindEnd ? default : Schedule(range, block);
        }

        // padding: bytes behind it that jobs may touch.
        protected JobHandle BeginRead(in EptBlock block, long offset, int bytes, int padding)
        {
            // Nodes come to be known while slots are in use: room for the largest is made when it is met.
            m_file.Reserve((long)bytes + padding);
            return DependencyOf(m_file.Begin(Blocks.PathOf(block), offset, bytes));
        }

        protected sealed override void EndRead() => m_file.End();

        protected sealed override void Warn(DecodeResult result)
        {
            if (result.Error != 0)
            {
                var block = Blocks[Range.Block];
                Blocks.EndNode(block, block.FirstInNode + Range.First + result.Points);
            }
            WarnBroken(result);
        }

        protected abstract void DisposeTables();

        protected sealed override void DisposeMemory()
        {
            m_file.Dispose();
            DisposeTables();
        }
    }
}
