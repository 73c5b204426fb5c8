using FastPoints.Reading;

namespace FastPoints.Las
{
    internal sealed class LasReader : RecordReader
    {
        readonly LasFile m_las;

        LasReader(LasFile las) : base(las.Info, new SourceHandle(las.Info.Path), las.Info.RecordBytes)
        {
            m_las = las;
            SetRecords(las.Layout.Fields, las.Header.PointsOffset, false, Info.PointsReadable);
        }

        // Whatever the header says about compression.
        internal static PointReader OpenUncompressed(LasFile las, FileSource source)
        {
            las.Info.PointsReadable = LasClaims.CountReadable(las.Header, source.Length, las.Info);
            LasClaims.CheckBounds(las.Header, source, las.Info.PointsReadable, las.Info);
            return new LasReader(las);
        }

        internal override LasFile Las => m_las;

        public LasHeader Header => m_las.Header;

        public LasVlrTable Vlrs => m_las.Vlrs;
    }
}
