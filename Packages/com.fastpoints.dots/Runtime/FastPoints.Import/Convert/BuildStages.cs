namespace FastPoints.Convert
{
    /// <summary>What a conversion goes through, in this order, as its progress names it.</summary>
    public static class BuildStages
    {
        /// <summary>Some points of the source decide on the partition.</summary>
        public const string Sample = "sample";

        /// <summary>All points go to their chunks.</summary>
        public const string Read = "read";

        /// <summary>Chunks that came out too large or too small.</summary>
        public const string Split = "split";

        /// <summary>Chunks become nodes.</summary>
        public const string Index = "index";

        /// <summary>The levels above the chunks.</summary>
        public const string Merge = "merge";

        public const string Finish = "finish";
    }
}
