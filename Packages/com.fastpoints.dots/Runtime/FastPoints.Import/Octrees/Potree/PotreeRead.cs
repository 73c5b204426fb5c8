using System;
using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Octrees
{
    /// <summary>The common base of the slots for Potree's own encodings: the batch, one read, and how a range begins and
    /// ends.</summary>
    abstract class PotreeRead : SlotRead
    {
        protected PotreeRead(PotreeNodeReader reader, PointSchema wanted, int capacity, long inputBytes, Allocator allocator)
            : base(reader, wanted, capacity, allocator)
        {
            Reader = reader;
            try
            {
                File = new NativeFileRead(inputBytes, allocator);
            }
            catch (ArgumentException)
            {
                Dispose();
                throw;
            }
        }

        protected PotreeNodeReader Reader { get; }
        protected NativeFileRead File { get; }

        /// <summary>Starts the read and the jobs behind it.</summary>
        protected abstract JobHandle Schedule(BlockRange range, in PotreeBlock block);

        protected sealed override JobHandle Schedule(BlockRange range) => Schedule(range, Reader.Block(range.Block));

        protected sealed override void EndRead() => File.End();

        protected sealed override void Warn(DecodeResult result)
        {
            if (result.Error != PotreeError.None)
                WarnBroken(result);
        }

        /// <summary>Turns the error of a range into a warning, or into an exception.</summary>
        protected virtual void WarnBroken(DecodeResult result) => Reader.WarnBroken(Range.Block,
            "has positions beyond the 32-bit grid of the cloud: they are at its edge", null, -1);

        protected virtual void DisposeTables() { }

        protected sealed override void DisposeMemory()
        {
            if (File == null)
                return;
            File.Dispose();
            DisposeTables();
        }

        /// <summary>Plans the passes that copy the wanted plain columns out of records.</summary>
        /// <param name="isTaken">Whether a column's attribute is copied.</param>
        /// <param name="recordStart">Offset in the cloud's record at which the records begin.</param>
        protected FieldCopy[] PlanCopies(Func<PotreeAttribute, bool> isTaken, int recordStart)
        {
            var fields = new List<PointField>();
            var columns = new List<PointColumn>();
            for (int i = 0; i < Points.Schema.Count; i++)
            {
                if (!isTaken(Reader.Layout.Attributes[Reader.Layout.AttributeOf(Points.Schema[i])]))
                    continue;
                var field = Reader.Layout.FieldOf(Points.Schema[i]);
                field.ByteOffset -= recordStart;
                fields.Add(field);
                columns.Add(Points.Column(i));
            }
            return FieldCopyPlan.Make(fields.ToArray(), columns.ToArray());
        }
    }

    /// <summary>A Potree cloud whose nodes have an encoding of Potree's own: the members that slots use.</summary>
    internal abstract class PotreeNodeReader : PotreeReader
    {
        private protected PotreeNodeReader(SourceInfo info, BoundsGeo cube, double spacing) : base(info, cube, spacing) { }

        internal abstract PotreeLayout Layout { get; }

        /// <summary>Starts to read bytes of the file that holds a block.</summary>
        internal abstract JobHandle BeginRead(NativeFileRead read, int block, long offset, int bytes);

        /// <summary>Grid steps from a block's corner to the cloud's.</summary>
        internal abstract int3 ShiftOf(int block);
    }
}
