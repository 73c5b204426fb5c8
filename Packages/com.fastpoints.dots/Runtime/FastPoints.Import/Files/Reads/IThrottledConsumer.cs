namespace FastPoints.Files
{
    /// <summary>A consumer that passes blocks on to something slower, such as a disk.</summary>
    public interface IThrottledConsumer : IBlockConsumer
    {
        /// <summary>Whether it takes another block now; may wait for a millisecond. Main thread.</summary>
        bool IsReady { get; }
    }
}
