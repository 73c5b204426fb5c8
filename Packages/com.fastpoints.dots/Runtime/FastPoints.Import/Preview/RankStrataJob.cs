using FastPoints.Files;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Preview
{
    /// <summary>Which strata have the next runs, by an order of which every beginning is spread over the file.</summary>
    [BurstCompile]
    struct RankStrataJob : IJob
    {
        public SampleOrder Order;

        /// <summary>Of the order: where the last run of this stopped.</summary>
        public NativeReference<int> NextPlace;

        /// <summary>Runs that have a stratum.</summary>
        public int FirstRank;

        /// <summary>These, and those that get one.</summary>
        public int EndRank;

        /// <summary>For each stratum, its run's rank + 1; 0 for those that were not come to.</summary>
        public NativeArray<int> Ranks;

        public void Execute()
        {
            int place = NextPlace.Value;
            for (int rank = FirstRank; rank < EndRank; place++)
            {
                int stratum = Order.StratumAt(place);
                if (stratum >= 0)
                    Ranks[stratum] = ++rank;
            }
            NextPlace.Value = place;
        }
    }
}
