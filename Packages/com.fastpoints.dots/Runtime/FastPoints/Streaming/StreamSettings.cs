namespace FastPoints.Streaming
{
    /// <summary>How much streaming may do at once. May be changed from frame to frame.</summary>
    public sealed class StreamSettings
    {
        public SelectionSettings Selection = SelectionSettings.Default;

        /// <summary>Reads under way at most, those that wait to be copied among them: each keeps its memory so long.</summary>
        public int MostReads = 24;

        /// <summary>Bytes of one read, unless a single node has more: neighbours in a file are read at once.</summary>
        public int BytesPerRead = 1 << 20;

        /// <summary>Bytes between two planes of one file that are read along, because another read would take longer.</summary>
        public int GapBytes = 32 << 10;

        /// <summary>Bytes and nodes that are copied into the pool at most in one frame; one node always is.</summary>
        public int UploadBytesPerFrame = 4 << 20;
        public int UploadNodesPerFrame = 512;

        /// <summary>Reads of a file, or of a damaged node, that fail one after the other until it is a hole.</summary>
        public int MostTries = 3;

        /// <summary>Frames until a read that failed is tried again.</summary>
        public int FramesToRetry = 30;

        /// <summary>Frames that a node must not be wanted for until its read is called off.</summary>
        public int FramesToCancel = 10;

        /// <summary>Frames that the camera's motion is prolonged by for what is read ahead; 0 for none.</summary>
        public int FramesAhead = 20;

        /// <summary>Points that are read ahead, as a share of the budget.</summary>
        public float ShareAhead = 0.25f;

        /// <summary>Bytes of hierarchy pages that are kept though nothing of them has been in view for a while.</summary>
        public long HierarchyBytes = 256L << 20;
    }
}
