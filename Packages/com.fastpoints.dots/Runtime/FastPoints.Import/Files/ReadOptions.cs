namespace FastPoints.Files
{
    /// <summary>What a caller knows of files better than they say themselves. All of it may be left out.</summary>
    public sealed class ReadOptions
    {
        /// <summary>Names of the columns of a text file, in their order: x, y, z, i, r, g, b, nx, ny, nz or any other;
        /// "-" leaves a column out. Null: by the file's own names, or guessed.</summary>
        public string[] TextColumns;
    }
}
