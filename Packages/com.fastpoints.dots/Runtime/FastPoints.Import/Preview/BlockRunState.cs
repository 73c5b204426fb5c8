namespace FastPoints.Preview
{
    /// <summary>How far <see cref="ListBlockRunsJob"/> has come.</summary>
    struct BlockRunState
    {
        /// <summary>Of those that the job knows.</summary>
        public int Block;

        public int Place;

        /// <summary>Points at the places before.</summary>
        public int Gathered;

        /// <summary>Of these, those of blocks before.</summary>
        public int Before;
    }
}
