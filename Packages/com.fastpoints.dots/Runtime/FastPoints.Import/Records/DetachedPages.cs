namespace FastPoints.Records
{
    /// <summary>Full pages of one chunk that memory has no more room for. Blittable.</summary>
    public struct DetachedPages
    {
        public int Chunk;
        public RecordPages Pages;
    }
}
