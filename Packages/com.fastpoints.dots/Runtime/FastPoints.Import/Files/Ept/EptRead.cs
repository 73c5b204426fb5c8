using System;
using FastPoints.Points;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Files
{
    /// <summary>What the slots of EPT nodes have in common: the batch, the read of a node's file, how a range begins and
    /// ends.</summary>
    abstract class EptRead : BlockRead
    {
        readonly Allocator m_allocator;
        NativeReference<DecodeResult> m_result;
        NativeFileRead m_file;
        int m_fileCapacity;
        bool m_isBusy;
        bool m_isDisposed;

        protected EptRead(EptReader reader, PointSchema wanted, int capacity, Allocator allocator)
        {
            m_allocator = allocator;
            Reader = reader;
            Points = new PointBatch(wanted, capacity, allocator);
            m_result = new NativeReference<DecodeResult>(allocator);
            Result = m_result;
        }

        protected EptReader Reader { get; }

        /// <summary>The bytes of the read that began last, and as many as were asked for behind them.</summary>
        protected NativeArray<byte> Input => m_file.Buffer;

        /// <summary>Starts the read and the jobs behind it.</summary>
        protected abstract JobHandle Schedule(BlockRange range, in EptBlock block);

        /// <summary>Says what became of a range that did not give all of its points.</summary>
        protected abstract void Warn(DecodeResult result);

        public sealed override void Begin(BlockRange range)
        {
            if (m_isBusy)
                throw new InvalidOperationException("the slot is still reading; Complete it first");
            var block = Reader.Block(range.Block);
            if (range.First < 0 || range.Count < 0 || range.Count > Points.Capacity || range.Count > block.Points - range.First)
                throw new ArgumentOutOfRangeException(nameof(range), range.Count, "the range leaves its block or the slot");
            Range = range;
            FirstPoint = block.FirstPoint + range.First;
            Points.Count = 0;
            m_result.Value = default;
            m_isBusy = true;
            bool isBehindEnd = block.FirstInNode > 0 && block.FirstInNode + range.First >= Reader.EndOfNode(block);
            Decoded = range.Count == 0 || isBehindEnd ? default : Schedule(range, block);
        }

        /// <summary>Reads a stretch of a block's file.</summary>
        /// <param name="padding">Bytes behind it that jobs may touch.</param>
        protected JobHandle BeginRead(in EptBlock block, long offset, int bytes, int padding)
        {
            if (m_file == null || m_fileCapacity < bytes + padding)
            {
                // Nodes come to be known while slots are in use: room for the largest is made when it is met.
                m_file?.Dispose();
                m_fileCapacity = bytes + padding;
                m_file = new NativeFileRead(Reader.Info.Path, default, m_fileCapacity, m_allocator);
            }
            return m_file.Begin(Reader.PathOf(block.Level, block.Cell), offset, bytes);
        }

        public sealed override void Complete()
        {
            if (!m_isBusy)
                return;
            m_isBusy = false;
            Decoded.Complete();
            m_file?.End();
            var result = m_result.Value;
            Points.Count = result.Points;
            if (result.Error != 0)
            {
                var block = Reader.Block(Range.Block);
                Reader.EndNode(block, block.FirstInNode + Range.First + result.Points);
            }
            Warn(result);
        }

        protected abstract void DisposeTables();

        public sealed override void Dispose()
        {
            if (m_isDisposed)
                return;
            m_isDisposed = true;
            m_isBusy = false;
            Decoded.Complete();
            m_file?.Dispose();
            DisposeTables();
            Points.Dispose();
            m_result.Dispose();
        }

        /// <summary>The passes that copy the wanted columns out of the schema's records.</summary>
        protected static LasFieldCopy[] PlanCopies(EptReader reader, PointSchema wanted, PointBatch batch)
        {
            var fields = new LasField[wanted.Count];
            var columns = new PointColumn[wanted.Count];
            for (int i = 0; i < fields.Length; i++)
            {
                fields[i] = reader.Index.FieldOf(wanted[i]);
                columns[i] = batch.Column(i);
            }
            return LasCopyPlan.Make(fields, columns);
        }
    }
}
