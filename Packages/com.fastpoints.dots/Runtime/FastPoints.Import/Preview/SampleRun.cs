namespace FastPoints.Preview
{
    /// <summary>Points of a sample that lie together in the file: all that is known of one stretch of it.</summary>
    public struct SampleRun
    {
        /// <summary>Number of the stretch, in the file's order; several entries in a row may be of one.</summary>
        public int Stretch;

        /// <summary>Of the first point in the sample.</summary>
        public int First;

        public int Count;

        /// <summary>Points of the file that each stands for.</summary>
        public double Weight;
    }
}
