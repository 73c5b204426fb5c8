using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Sampling
{
    /// <summary>Lists the runs that the waves of a <see cref="RunPlan"/> have reached, in the file's order, by place.</summary>
    [BurstCompile]
    struct ListRunsJob : IJob
    {
        public RunPlan Plan;

        /// <summary>For each stratum, its run's rank + 1; 0 for those that no wave has reached. The next wave may have ranks
        /// already.</summary>
        [ReadOnly] public NativeArray<int> Ranks;

        /// <summary>Range of the strata to examine.</summary>
        public int First;
        public int End;

        /// <summary>Number of runs that were reached.</summary>
        public int RunCount;

        public long PointsInSource;

        public NativeList<SampleRun> Runs;

        public void Execute()
        {
            for (int stratum = First; stratum < End; stratum++)
            {
                int rank = Ranks[stratum] - 1;
                if (rank < 0 || rank >= RunCount)
                    continue;
                int count = Plan.PointsOf(stratum, rank);
                Runs.Add(new SampleRun
                {
                    Segment = Runs.Length,
                    First = Plan.PlaceOf(rank),
                    Count = count,
                    Weight = PointsInSource / ((double)RunCount * count),
                });
            }
        }
    }
}
