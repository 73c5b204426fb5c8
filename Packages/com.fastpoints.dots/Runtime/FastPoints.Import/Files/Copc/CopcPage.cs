namespace FastPoints.Files
{
    /// <summary>A piece of the hierarchy, in the file: entries of a node and of those below it.</summary>
    struct CopcPage
    {
        public long Offset;
        public long Bytes;
    }
}
