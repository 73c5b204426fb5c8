using FastPoints.Points;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Files
{
    /// <summary>Columns that a node's own file gave, to the cloud's batch and grid; the next run of points after those that are
    /// there.</summary>
    [BurstCompile]
    unsafe struct MovePotreeJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Input;
        [ReadOnly] public NativeReference<DecodeResult> Decoded;
        [ReadOnly] public NativeArray<PointColumn> From;
        [ReadOnly] public NativeArray<PointColumn> To;
        public NativeArray<byte> Columns;
        public NativeReference<DecodeResult> Result;

        /// <summary>First byte of X, Y, Z in the batch; -1 where one is not wanted.</summary>
        public int3 Position;

        /// <summary>From the file's offset to the cloud's, in grid steps.</summary>
        public int3 Shift;

        /// <summary>Place of the run in the batch.</summary>
        public int First;

        /// <summary>Points that both sides have room for.</summary>
        public int Capacity;

        public void Execute()
        {
            var result = Result.Value;
            int count = math.min(Decoded.Value.Points, Capacity);
            // Behind a run that broke off there is no place for this one.
            if (result.Points != First || count <= 0)
                return;
            byte* input = (byte*)Input.GetUnsafeReadOnlyPtr();
            byte* columns = (byte*)Columns.GetUnsafePtr();
            for (int i = 0; i < To.Length; i++)
            {
                int size = To[i].Type.SizeOf();
                UnsafeUtility.MemCpy(columns + To[i].OffsetBytes + (long)First * size, input + From[i].OffsetBytes, (long)count * size);
            }
            for (int axis = 0; axis < 3; axis++)
                if (Position[axis] >= 0 && Shift[axis] != 0)
                    result.Error |= DecodePotreeJob.Move((int*)(columns + Position[axis]) + First, count, Shift[axis]);
            result.Points = First + count;
            Result.Value = result;
        }
    }
}
