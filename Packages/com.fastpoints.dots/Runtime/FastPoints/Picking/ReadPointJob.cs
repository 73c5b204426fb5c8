using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Picking
{
    /// <summary>What one plane of a node says of one point.</summary>
    [BurstCompile]
    public unsafe struct ReadPointJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Plane;
        public PlaneShape Shape;
        public ulong Hash;

        /// <summary>The plane was made in memory: there is no hash.</summary>
        public bool IsMade;
        public int BlockCount;
        public int Block;

        /// <summary>In its block.</summary>
        public int Index;

        /// <summary>By column, as they are packed.</summary>
        public NativeArray<ulong> Values;
        public NativeReference<bool> IsDamaged;

        public void Execute()
        {
            void* start = Plane.GetUnsafeReadOnlyPtr();
            IsDamaged.Value = (!IsMade && ContentHash.Of(start, Plane.Length) != Hash) ||
                !PlaneView.IsSound(start, Plane.Length, Shape, BlockCount);
            if (IsDamaged.Value)
                return;
            var view = new PlaneView(start, Shape, BlockCount);
            for (int c = 0; c < Shape.ColumnCount; c++)
                Values[c] = view.ValueAt(Block, c, Index);
        }
    }
}
