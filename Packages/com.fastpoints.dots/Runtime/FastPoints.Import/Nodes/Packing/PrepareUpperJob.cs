using FastPoints.Core;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Nodes
{
    /// <summary>Prepares the chunks' tops, which are in order already, for the sampling of the upper levels.</summary>
    [BurstCompile]
    internal unsafe struct PrepareUpperJob : IJob
    {
        /// <summary>A slice takes about 4 ms.</summary>
        public const int PointsOfSlice = 100000;

        /// <summary>The points of this slice. The slices of one cloud follow one another.</summary>
        public int First;
        public int End;
        public RecordLayout Layout;
        public Grid3 Corner;
        [ReadOnly] public NativeArray<byte> Records;
        public NativeArray<byte> CommonCubeLog2;
        public NativeArray<uint> Priority;

        public SliceTimes Slices;

        public void Execute()
        {
            long begin = SliceTimes.Begin();
            Run();
            Slices.End(begin);
        }

        void Run() =>
            SampleInputs.Prepare((byte*)Records.GetUnsafeReadOnlyPtr(), First, End, Layout, Corner,
                (byte*)CommonCubeLog2.GetUnsafePtr(), (uint*)Priority.GetUnsafePtr());
    }
}
