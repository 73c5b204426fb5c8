namespace FastPoints.Streaming
{
    /// <summary>What one frame did, and the state after it.</summary>
    public struct FrameStats
    {
        public uint Frame;
        public int SelectedNodes;
        public long SelectedPoints;

        /// <summary>Pages that the selection reached but that are not loaded: it may choose more when they are.</summary>
        public int MissingPages;
        public int RequestedNodes;
        public long RequestedBytes;

        /// <summary>Bytes of reads that ended, including gaps between planes.</summary>
        public long ReadBytes;
        public int UploadedNodes;
        public long UploadedBytes;
        public int EvictedNodes;
        public int DrawnNodes;
        public long DrawnPoints;

        /// <summary>Drawn nodes that appear or leave: some of their points are drawn.</summary>
        public int FadingNodes;

        /// <summary>Nodes that have memory, including those in flight, and the pool's bytes.</summary>
        public int CachedNodes;
        public long PoolBytes;
        public long HierarchyBytes;
        public int ReadsInFlight;

        /// <summary>Whether all selected nodes are drawn and nothing is missing, in flight or fading.</summary>
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
