using System;
using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Octrees
{
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

        protected abstract JobHandle Schedule(BlockRange range, in PotreeBlock block);

        protected sealed override JobHandle Schedule(BlockRange range) => Schedule(range, Reader.Block(range.Block));

        protected sealed override void EndRead() => File.End();

        protected sealed override void Warn(DecodeResult result)
        {
            if (result.Error != PotreeError.None)
                WarnBroken(result);
        }

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

        // recordStart: offset in the cloud's record at which the records begin.
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

    internal abstract class PotreeNodeReader : PotreeReader
    {
        private protected PotreeNodeReader(SourceInfo info, BoundsGeo cube, double spacing) : base(info, cube, spacing) { }

        internal abstract PotreeLayout Layout { get; }

        internal abstract JobHandle BeginRead(NativeFileRead read, int block, long offset, int bytes);

        // Grid steps from a block's corner to the cloud's.
        internal abstract int3 ShiftOf(int block);
    }
}
