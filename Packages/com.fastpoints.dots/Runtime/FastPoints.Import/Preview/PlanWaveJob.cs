using FastPoints.Files;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Preview
{
    /// <summary>The runs of one wave, in the file's order.</summary>
    [BurstCompile]
    struct PlanWaveJob : IJob
    {
        public RunPlan Plan;

        /// <summary>Of the order: where the last wave stopped.</summary>
        public NativeReference<int> NextPlace;

        /// <summary>Runs of the waves before.</summary>
        public int FirstRank;

        /// <summary>Runs of these and of this wave.</summary>
        public int EndRank;

        /// <summary>For each stratum, its run's rank + 1; 0 for those that no wave has come to.</summary>
        public NativeArray<int> Ranks;

        public NativeList<PointRun> Runs;

        /// <summary>Of the sample's places: those of the runs become 1.</summary>
        public NativeArray<byte> Filled;

        public void Execute()
        {
            int place = NextPlace.Value;
            for (int rank = FirstRank; rank < EndRank; place++)
            {
                int stratum = Plan.Order.StratumAt(place);
                if (stratum >= 0)
                    Ranks[stratum] = ++rank;
            }
            NextPlace.Value = place;

            Runs.Clear();
            for (int stratum = 0; stratum < Ranks.Length; stratum++)
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
