namespace FastPoints.Picking
{
    /// <summary>What a search has come to.</summary>
    public sealed class PickResult
    {
        /// <summary>Null where nothing was hit.</summary>
        public PickedPoint Point { get; internal set; }

        /// <summary>The search ended at <see cref="PickOptions.MostBytes"/>: there may be a nearer point.</summary>
        public bool IsPartial { get; internal set; }

        public int NodesRead { get; internal set; }
        public long BytesRead { get; internal set; }
    }
}
