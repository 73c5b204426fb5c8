namespace FastPoints.Files
{
    /// <summary>Evenly spaced points of a source (First, First + Step, ...) and where in a batch they go, one after the
    /// other.</summary>
    public struct PointRun
    {
        /// <summary>Over the whole source.</summary>
        public long First;

        /// <summary>Points from one to the next, at least 1.</summary>
        public int Step;

        /// <summary>At least 1.</summary>
        public int Count;

        /// <summary>Of the first one in the batch.</summary>
        public int Place;

        public long Last => First + (Count - 1L) * Step;
    }
}
