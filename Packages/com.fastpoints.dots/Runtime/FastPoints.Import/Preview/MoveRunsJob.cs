using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Preview
{
    /// <summary>Runs of places become runs of the points that were left when gaps were closed.</summary>
    [BurstCompile]
    struct MoveRunsJob : IJob
    {
        /// <summary>1 at each place whose point was kept.</summary>
        [ReadOnly] public NativeArray<byte> Filled;

        public int Places;

        /// <summary>Scratch, one more than there are places.</summary>
        public NativeArray<int> PointOfPlace;

        public NativeList<SampleRun> Runs;

        public void Execute()
        {
            int kept = 0;
            for (int place = 0; place < Places; place++)
            {
                PointOfPlace[place] = kept;
                kept += Filled[place];
            }
            PointOfPlace[Places] = kept;
            for (int i = 0; i < Runs.Length; i++)
            {
                var run = Runs[i];
                int end = PointOfPlace[run.First + run.Count];
                run.First = PointOfPlace[run.First];
                run.Count = end - run.First;
                Runs[i] = run;
            }
        }
    }
}
