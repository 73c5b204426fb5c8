using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Preview
{
    /// <summary>Runs of places become runs of the points that were left when gaps were closed.</summary>
    [BurstCompile]
    struct MoveRunsJob : IJob
    {
        /// <summary>One more than there are places.</summary>
        [ReadOnly] public NativeArray<int> PointOfPlace;

        public int First;
        public int End;
        public NativeList<SampleRun> Runs;

        public void Execute()
        {
            for (int i = First; i < End; i++)
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
