namespace FastPoints.Tests.Files
{
    /// <summary>How a scan's bytestreams are cut into packets.</summary>
    public enum E57Packing
    {
        /// <summary>The same records of every stream, as far as bytes allow: as most writers do.</summary>
        Even,

        /// <summary>Pieces of any length, some of them empty, so that streams run ahead of each other.</summary>
        Ragged,

        /// <summary>One stream to its end, then the next.</summary>
        OneByOne,
    }
}
