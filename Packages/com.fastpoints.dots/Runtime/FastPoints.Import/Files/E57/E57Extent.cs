namespace FastPoints.Files
{
    /// <summary>Consecutive pages of a file, and where a buffer holds them.</summary>
    struct E57Extent
    {
        public long FirstPage;
        public int Pages;

        /// <summary>Its first page's place in the buffer, in pages.</summary>
        public int BufferPage;

        public long LogicalStart => FirstPage * E57Pages.DataBytes;

        public long LogicalEnd => (FirstPage + Pages) * E57Pages.DataBytes;

        /// <summary>What is added to a logical offset to have its place among the buffer's content, once the checksums are
        /// taken out.</summary>
        public long ToBuffer => ((long)BufferPage - FirstPage) * E57Pages.DataBytes;
    }
}
