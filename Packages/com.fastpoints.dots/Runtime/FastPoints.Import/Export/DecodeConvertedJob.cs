using FastPoints.Reading;
using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Export
{
    internal struct PlaneColumnTarget
    {
        public int Plane; // Among the wanted planes; 0 for the position.
        public int Column;
        public StoredColumn Stored;
        public PointColumn To;
    }

    /// <summary>Checks the planes of a node, and unpacks some of its points into columns.</summary>
    [BurstCompile]
    internal unsafe struct DecodeConvertedJob : IJob
    {
        [ReadOnly] public NativeArray<byte> File;

        [ReadOnly] public NativeArray<PlaneRange> Ranges;

        [ReadOnly] public NativeArray<long> PlaneOffsets;
        [ReadOnly] public NativeArray<PlaneShape> Shapes;
        [ReadOnly] public NativeArray<PlaneColumnTarget> Targets;
        public int BlockCount;
        public Grid3 Corner;
        public int First;
        public int Count;
        public NativeArray<byte> Columns;
        public NativeReference<DecodeResult> Result;

        public void Execute()
        {
            var file = (byte*)File.GetUnsafeReadOnlyPtr();
            for (int p = 0; p < Ranges.Length; p++)
            {
                byte* plane = file + PlaneOffsets[p];
                ulong hash = ContentHash.Of(plane, Ranges[p].LengthBytes);
                if (hash == Ranges[p].Hash && PlaneView.IsValid(plane, Ranges[p].LengthBytes, Shapes[p], BlockCount))
                    continue;
                Result.Value = new DecodeResult { Error = 1 + p, ErrorOffset = Ranges[p].OffsetBytes, ActualHash = hash };
                return;
            }
            for (int t = 0; t < Targets.Length; t++)
                Unpack(file, Targets[t]);
            Result.Value = new DecodeResult { Points = Count };
        }

        void Unpack(byte* file, in PlaneColumnTarget target)
        {
            var view = new PlaneView(file + PlaneOffsets[target.Plane], Shapes[target.Plane], BlockCount);
            var values = new ColumnUnpacker { View = view, Column = target.Column, Stored = target.Stored };
            byte* to = (byte*)Columns.GetUnsafePtr() + target.To.OffsetBytes;
            long corner = target.Column == 0 ? Corner.X : target.Column == 1 ? Corner.Y : Corner.Z;
            int at = 0;
            for (int b = 0; b < BlockCount && at < First + Count; b++)
            {
                int points = view.PointsOf(b), begin = math.max(0, First - at);
                int count = math.min(points, First + Count - at) - begin;
                at += points;
                if (count <= 0)
                    continue;
                if (target.Plane == 0)
                    view.UnpackPositions(b, target.Column, corner, begin, count, (long*)to);
                else
                    values.Unpack(b, begin, count, to);
                to += count * target.To.Type.SizeOf();
            }
        }
    }

    /// <summary>Takes what edits made of a node's points into the batch, without those that were deleted.</summary>
    [BurstCompile]
    internal unsafe struct GatherEditedJob : IJob
    {
        public NativeArray<byte> Columns;
        [ReadOnly] public NativeArray<PointColumn> AllColumns;
        [ReadOnly] public NativeArray<EditedBlock> Edited;
        [ReadOnly] public NativeArray<byte> Values; // By block and point; the same columns of these and of the batch.
        [ReadOnly] public NativeArray<PointColumn> From;
        [ReadOnly] public NativeArray<PointColumn> To;
        public NativeArray<int> Chosen;
        [ReadOnly] public NativeArray<byte> File; // With the plane of the position.
        public long PlaneOffset;
        public PlaneShape Shape;
        public int BlockCount;
        public int First;
        public int Count;
        public NativeReference<DecodeResult> Result;

        public void Execute()
        {
            var result = Result.Value;
            if (result.Error != 0)
                return;
            var view = new PlaneView((byte*)File.GetUnsafeReadOnlyPtr() + PlaneOffset, Shape, BlockCount);
            int at = 0, kept = 0;
            for (int b = 0; b < BlockCount && at < First + Count; b++)
            {
                int points = view.PointsOf(b), begin = math.max(0, First - at), end = math.min(points, First + Count - at);
                for (int i = begin; i < end; i++)
                    if (!Edited[b].Deleted.Has(i))
                        Chosen[kept++] = at + i - First;
                if (Edited[b].HasChangedValues && begin < end)
                    Copy(b * PlaneShape.MaxPointsPerBlock + begin, at + begin - First, end - begin);
                at += points;
            }
            for (int c = 0; c < AllColumns.Length && kept < Count; c++)
                PointRecords.Gather((byte*)Columns.GetUnsafePtr(), AllColumns[c], (int*)Chosen.GetUnsafeReadOnlyPtr(), kept, 0);
            result.Points = kept;
            Result.Value = result;
        }

        void Copy(int from, int to, int count)
        {
            for (int c = 0; c < From.Length; c++)
                UnsafeUtility.MemCpy(To[c].At((byte*)Columns.GetUnsafePtr(), to),
                    From[c].At((byte*)Values.GetUnsafeReadOnlyPtr(), from), (long)count * To[c].Type.SizeOf());
        }
    }
}
