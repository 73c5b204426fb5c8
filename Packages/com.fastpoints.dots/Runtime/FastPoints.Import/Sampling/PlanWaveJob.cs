using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Sampling
{
    /// <summary>Plans the runs of one wave, in the file's order, for the strata examined.</summary>
    [BurstCompile]
    struct PlanWaveJob : IJob
    {
        public RunPlan Plan;

        /// <summary>Number of runs in earlier waves.</summary>
        public int FirstRank;

        /// <summary>For each stratum, its run's rank + 1; 0 for those that no wave has reached.</summary>
        [ReadOnly] public NativeArray<int> Ranks;

        /// <summary>Range of the strata to examine.</summary>
        public int First;
        public int End;

        public NativeList<PointRun> Runs;

        /// <summary>One for each place of the sample; those of the runs become 1.</summary>
        public NativeArray<byte> Filled;

        public void Execute()
        {
            for (int stratum = First; stratum < End; stratum++)
            {
                int rank = Ranks[stratum] - 1;
                if (rank < FirstRank)
                    continue;
                bool isSplit = Plan.RunOf(stratum, rank, out var run, out var second);
                Add(run);
                if (isSplit)
                    Add(second);
            }
        }

        void Add(in PointRun run)
        {
            Runs.Add(run);
            for (int i = 0; i < run.Count; i++)
                Filled[run.Place + i] = 1;
        }
    }
}
