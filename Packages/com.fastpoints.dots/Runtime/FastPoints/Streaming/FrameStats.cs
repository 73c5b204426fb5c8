namespace FastPoints.Streaming
{
    /// <summary>What one frame did, and where things stand after it.</summary>
    public struct FrameStats
    {
        public uint Frame;
        public int SelectedNodes;
        public long SelectedPoints;

        /// <summary>Pages that the selection came to and that are not loaded: it may choose more when they are.</summary>
        public int MissingPages;
        public int RequestedNodes;
        public long RequestedBytes;

        /// <summary>Of reads that ended, gaps between planes included.</summary>
        public long ReadBytes;
        public int UploadedNodes;
        public long UploadedBytes;
        public int EvictedNodes;
        public int DrawnNodes;
        public long DrawnPoints;

        /// <summary>Nodes with memory, those on their way included, and the pool's bytes.</summary>
        public int CachedNodes;
        public long PoolBytes;
        public long HierarchyBytes;
        public int ReadsUnderWay;

        /// <summary>Selected nodes are drawn, nothing is missing and nothing on its way.</summary>
        public bool IsSettled;

        /// <summary>Main-thread time of each step.</summary>
        public double ReceiveMs;
        public double SelectMs;
        public double UploadMs;
        public double RequestMs;
        public double ListMs;

        public double TotalMs => ReceiveMs + SelectMs + UploadMs + RequestMs + ListMs;
    }
}
