namespace FastPoints.Streaming
{
    /// <summary>How much streaming may do at once. The settings may change from frame to frame.</summary>
    public sealed class StreamSettings
    {
        public LodSettings Selection = LodSettings.Default;

        /// <summary>The most reads in flight, including those that wait to be copied: each keeps its memory that long.</summary>
        public int MaxReads = 24;

        /// <summary>Bytes of one read, unless a single node has more: neighbours in a file are read together.</summary>
        public int MaxBytesPerRead = 1 << 20;

        /// <summary>Gaps between two planes of one file up to this are read along: another read would take longer.</summary>
        public int MaxGapBytes = 32 << 10;

        /// <summary>The most bytes and nodes that are copied into the pool in one frame; one node always is.</summary>
        public int MaxUploadBytesPerFrame = 4 << 20;
        public int MaxUploadNodesPerFrame = 512;

        /// <summary>After this many consecutive failures, a file or a damaged node becomes a hole.</summary>
        public int MaxTries = 3;

        /// <summary>Frames before a failed read is retried.</summary>
        public int FramesToRetry = 30;

        /// <summary>A read is cancelled if its node has not been wanted for this many frames.</summary>
        public int FramesToCancel = 10;

        /// <summary>The camera's motion is extrapolated by this many frames for reading ahead; 0 for none.</summary>
        public int PrefetchFrames = 20;

        /// <summary>Points that are read ahead, as a share of the budget; twice as many of web servers.</summary>
        public float PrefetchShare = 0.25f;
        internal const float SceneFadeSeconds = 0.25f; // What scenes and the fly verb set; FadeSeconds itself starts at 0.

        /// <summary>How long a node takes to appear or to leave, point by point; 0 for at once. The pace is that of
        /// <see cref="StreamContext.FrameSeconds"/>.</summary>
        public float FadeSeconds;

        /// <summary>Bytes of hierarchy pages that are kept even if they have been out of view for a while.</summary>
        public long MaxHierarchyBytes = 256L << 20;
    }

    /// <summary>Limits of a selection. Blittable, for jobs.</summary>
    public struct LodSettings
    {
        /// <summary>The point budget of all clouds together. The first root is chosen however many points it has.</summary>
        public long PointBudget;

        /// <summary>A node is left out if the points above it lie closer on the screen: it would add nothing.</summary>
        public float MinScreenErrorPx;

        /// <summary>A node is left out if its box is smaller than this on the screen.</summary>
        public float MinNodePx;

        /// <summary>Nodes selected last time count as this many times as coarse, so that none flickers at the edge of the
        /// budget.</summary>
        public float Hysteresis;

        public static LodSettings Default => new LodSettings
        {
            PointBudget = 2_000_000,
            MinScreenErrorPx = 0.4f,
            MinNodePx = 1,
            Hysteresis = 1.15f,
        };
    }
}
