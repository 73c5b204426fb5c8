namespace FastPoints.Convert
{
    /// <summary>Some consecutive records of a temporary file.</summary>
    public struct RecordRun
    {
        public int File;
        public long First;
        public long Count;
    }
}
