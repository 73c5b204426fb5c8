namespace FastPoints.Files
{
    /// <summary>One (extended) variable length record: whose it is, what it is, where its bytes lie.</summary>
    public sealed class LasVlr
    {
        public const int HeaderBytes = 54;
        public const int ExtendedHeaderBytes = 60;

        public const string ProjectionUser = "LASF_Projection";
        public const string SpecificationUser = "LASF_Spec";
        public const ushort WktRecord = 2112;
        public const ushort GeoKeyDirectoryRecord = 34735;
        public const ushort GeoDoubleParamsRecord = 34736;
        public const ushort GeoAsciiParamsRecord = 34737;
        public const ushort ExtraBytesRecord = 4;

        public string UserId;
        public ushort RecordId;
        public string Description;

        /// <summary>Where its own header starts in the file.</summary>
        public long Offset;

        public long DataOffset;

        /// <summary>Bytes that lie in the file; fewer than claimed where it was cut.</summary>
        public long DataBytes;

        /// <summary>From the end of the file, with a 64-bit length (LAS 1.4).</summary>
        public bool IsExtended;

        public bool Is(string userId, ushort recordId) => RecordId == recordId && UserId == userId;
    }
}
