using FastPoints.Points;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Octree
{
    /// <summary>Prepares the chunks' tops, which are in order already, for the sampling of the upper levels.</summary>
    [BurstCompile]
    public unsafe struct PrepareUpperJob : IJob
    {
        public int Count;
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

        void Run()
        {
            Sampling.Prepare((byte*)Records.GetUnsafeReadOnlyPtr(), 0, Count, Layout, Corner, (byte*)CommonCubeLog2.GetUnsafePtr(),
                (uint*)Priority.GetUnsafePtr());
        }
    }
}
