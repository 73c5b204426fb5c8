using System;
using System.Collections.Generic;
using FastPoints.Points;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Files
{
    /// <summary>What the slots of Potree's own encodings have in common: the batch, one read, and how a range begins and
    /// ends.</summary>
    abstract class PotreeRead : BlockRead
    {
        NativeReference<DecodeResult> m_result;
        bool m_isBusy;
        bool m_isDisposed;

        protected PotreeRead(PotreeNodeReader reader, PointSchema wanted, int capacity, long inputBytes, Allocator allocator)
        {
            foreach (var column in wanted)
                reader.Layout.AttributeOf(column);
            Reader = reader;
            Points = new PointBatch(wanted, capacity, allocator);
            try
            {
                File = new NativeFileRead(reader.Info.Path, default, inputBytes, allocator);
            }
            catch (ArgumentException)
            {
                Points.Dispose();
                throw;
            }
            m_result = new NativeReference<DecodeResult>(allocator);
            Result = m_result;
        }

        protected PotreeNodeReader Reader { get; }
        protected NativeFileRead File { get; }

        /// <summary>Starts the read and the jobs behind it.</summary>
        protected abstract JobHandle Schedule(BlockRange range, in PotreeBlock block);

        public sealed override void Begin(BlockRange range)
        {
            if (m_isBusy)
                throw new InvalidOperationException("the slot is still reading; Complete it first");
            Reader.CheckRange(range, Points.Capacity);
            Range = range;
            FirstPoint = Reader.FirstPointOfBlock(range.Block) + range.First;
            Points.Count = 0;
            m_result.Value = default;
            Decoded = range.Count == 0 ? default : Schedule(range, Reader.Block(range.Block));
            m_isBusy = true;
        }

        public sealed override void Complete()
        {
            if (!m_isBusy)
                throw new InvalidOperationException("the slot has no range in flight");
            m_isBusy = false;
            Decoded.Complete();
            File.End();
            var result = m_result.Value;
            Points.Count = result.Points;
            if (result.Error != PotreeError.None)
                WarnBroken(result);
        }

        /// <summary>Turns the error of a range into a warning, or into an exception.</summary>
        protected virtual void WarnBroken(DecodeResult result) => Reader.WarnBroken(Range.Block,
            "has positions beyond the 32-bit grid of the cloud: they are at its edge", null, -1);

        protected virtual void DisposeTables()
        {
        }

        public sealed override void Dispose()
        {
            if (m_isDisposed)
                return;
            m_isDisposed = true;
            m_isBusy = false;
            Decoded.Complete();
            File.Dispose();
            DisposeTables();
            Points.Dispose();
            m_result.Dispose();
        }

        /// <summary>The passes that copy the wanted plain columns out of records.</summary>
        /// <param name="isTaken">Whether a column's attribute is copied.</param>
        /// <param name="recordStart">Byte of the cloud's record at which the records begin.</param>
        protected LasFieldCopy[] PlanCopies(Func<PotreeAttribute, bool> isTaken, int recordStart)
        {
            var fields = new List<LasField>();
            var columns = new List<PointColumn>();
            for (int i = 0; i < Points.Schema.Count; i++)
            {
                if (!isTaken(Reader.Layout.Attributes[Reader.Layout.AttributeOf(Points.Schema[i])]))
                    continue;
                fields.Add(Reader.Layout.FieldOf(Points.Schema[i].Name).MovedBy(-recordStart));
                columns.Add(Points.Column(i));
            }
            return LasCopyPlan.Make(fields.ToArray(), columns.ToArray());
        }
    }

    /// <summary>A Potree cloud whose nodes are in an encoding of Potree's own: what the slots ask of it.</summary>
    internal abstract class PotreeNodeReader : PotreeReader
    {
        private protected PotreeNodeReader(SourceInfo info, BoundsGeo cube, double spacing) : base(info, cube, spacing)
        {
        }

        internal abstract PotreeLayout Layout { get; }

        /// <summary>Starts to read bytes of the file that holds a block.</summary>
        internal abstract JobHandle BeginRead(NativeFileRead read, int block, long offset, int bytes);

        /// <summary>From a block's corner to the cloud's, in grid steps.</summary>
        internal abstract int3 ShiftOf(int block);
    }
}
