using FastPoints.Core;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Octrees
{
    /// <summary>The common base of the slots for EPT nodes: the batch, the read of a node's file, and how a range begins and
    /// ends.</summary>
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

        /// <summary>The bytes of the last read, and the requested padding behind them.</summary>
        protected NativeArray<byte> Input => m_file.Buffer;

        /// <summary>Starts the read and the jobs behind it.</summary>
        protected abstract JobHandle Schedule(BlockRange range, in EptBlock block);

        /// <summary>Reports what happened to a range that did not give all of its points.</summary>
        protected virtual void WarnBroken(DecodeResult result) { }

        protected sealed override JobHandle Schedule(BlockRange range)
        {
            var block = Blocks[range.Block];
            bool isBehindEnd = block.FirstInNode > 0 && block.FirstInNode + range.First >= Blocks.EndOfNode(block);
            return isBehindEnd ? default : Schedule(range, block);
        }

        /// <summary>Reads a segment of a block's file.</summary>
        /// <param name="padding">Number of bytes behind it that jobs may touch.</param>
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
