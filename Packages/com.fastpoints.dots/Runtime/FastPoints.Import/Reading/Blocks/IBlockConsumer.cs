using Unity.Jobs;

namespace FastPoints.Reading
{
    /// <summary>Processes every block of a source: see <see cref="SourceScan"/>.</summary>
    internal interface IBlockConsumer
    {
        /// <summary>Schedules jobs on the slot's columns. They must depend on <paramref name="decoded"/> and use the count in
        /// <c>read.Result</c>; a consumer whose jobs share state chains them itself.</summary>
        /// <param name="slot">A number from 0 to slots - 1: state for each slot needs no locks.</param>
        JobHandle Schedule(BlockRead read, int slot, JobHandle decoded);

        /// <summary>Called when the block's jobs are complete; blocks arrive in order. Main thread.</summary>
        void Completed(BlockRead read, int slot);
    }

    /// <summary>A consumer that passes blocks on to something slower, such as a disk.</summary>
    internal interface IThrottledConsumer : IBlockConsumer
    {
        /// <summary>Whether it can take another block now; it may wait for a millisecond. Main thread.</summary>
        bool IsReady { get; }
    }
}
