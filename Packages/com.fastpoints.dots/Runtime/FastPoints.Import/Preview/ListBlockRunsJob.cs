using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Preview
{
    /// <summary>Which points of a sample that is still collected are of which block, by place among those that are
    /// there.</summary>
    [BurstCompile]
    struct ListBlockRunsJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Filled;
        public SampleStrata Strata;

        /// <summary>Over the whole source, and one more: the end.</summary>
        [ReadOnly] public NativeArray<long> FirstPointOfBlock;

        /// <summary>Points that each one that is there stands for.</summary>
        public double Weight;

        public NativeList<SampleRun> Runs;

        public void Execute()
        {
            int place = 0, gathered = 0, stretch = 0;
            for (int block = 0; block + 1 < FirstPointOfBlock.Length; block++)
            {
                int before = gathered;
                for (; place < Strata.Count && Strata.Chosen(place) < FirstPointOfBlock[block + 1]; place++)
                    gathered += Filled[place];
                if (gathered > before)
                    Runs.Add(new SampleRun { Stretch = stretch++, First = before, Count = gathered - before, Weight = Weight });
            }
        }
    }
}
