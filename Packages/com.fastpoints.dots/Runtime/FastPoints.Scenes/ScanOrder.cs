namespace FastPoints.Scenes
{
    /// <summary>In what order a made cloud's points lie in its file.</summary>
    public enum ScanOrder
    {
        /// <summary>As acquired: station after station, scan line after scan line.</summary>
        Strip,
        /// <summary>By tiles of 50 m, row by row; as acquired within a tile.</summary>
        Tile,
        /// <summary>By class; as acquired within a class.</summary>
        Class,
        /// <summary>Shuffled: no two neighbours in the file are neighbours in space.</summary>
        Random,
    }
}
