using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Preview
{
    /// <summary>Which point is at or behind each place, once gaps have been closed. Slices go from front to back.</summary>
    [BurstCompile]
    struct NumberPlacesJob : IJob
    {
        /// <summary>1 at each place whose point was kept.</summary>
        [ReadOnly] public NativeArray<byte> Filled;

        public int First;
        public int End;

        /// <summary>One more than there are places; that of <see cref="First"/> is known.</summary>
        public NativeArray<int> PointOfPlace;

        public void Execute()
        {
            int kept = PointOfPlace[First];
            for (int place = First; place < End; place++)
            {
                kept += Filled[place];
                PointOfPlace[place + 1] = kept;
            }
        }
    }
}
