using Unity.Jobs;

namespace FastPoints.Reading
{
    internal interface IBlockConsumer
    {
        // The jobs must depend on decoded and use the count in read.Result; a consumer whose jobs share state chains them itself.
        // slot: from 0 to slots - 1, so that state for each slot needs no locks.
        JobHandle Schedule(BlockRead read, int slot, JobHandle decoded);

        // The block's jobs are complete; blocks arrive in order. Main thread.
        void Completed(BlockRead read, int slot);
    }

    internal interface IThrottledConsumer : IBlockConsumer
    {
        // It may wait for a millisecond. Main thread.
        bool IsReady { get; }
    }
}
