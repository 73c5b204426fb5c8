using System.Text;
using FastPoints.Reading;

namespace FastPoints.Las
{
    internal interface ILasSource
    {
        LasFile Las { get; }
    }

    internal sealed class LasFile
    {
        public LasHeader Header { get; private set; }
        public LasVlrTable Vlrs { get; private set; }
        public LasRecordLayout Layout { get; private set; }

        // Complete except for PointsReadable and the claimed bounds: only the reader knows how points lie in the file.
        public SourceInfo Info { get; private set; }

        public static LasFile Read(RandomAccessFile source)
        {
            var header = LasHeader.Read(source);
            var info = new SourceInfo
            {
                Path = source.Path,
                FileBytes = source.Length,
                Format = header.IsCompressed ? "LAZ" : "LAS",
                Version = "1." + header.VersionMinor,
                PointFormat = header.PointFormat,
                RecordBytes = header.RecordBytes,
                PointsClaimed = header.PointsClaimed,
            };
            int headerBytes = LasHeader.BytesOf(header.VersionMinor);
            if (header.HeaderBytes < headerBytes)
                info.Warn(LasHeader.At.HeaderBytes, "header size: wanted " + headerBytes + " for LAS " + info.Version + ", got "
                    + header.HeaderBytes + ": fields beyond it are taken as absent");
            var vlrs = LasVlrTable.Read(source, header, info);
            info.Transform = LasTransform.Read(header, info);
            LasFacts.Add(header, vlrs, info);
            ReadCrs(vlrs, info);

            var format = LasPointFormat.Of(header.PointFormat);
            var extra = vlrs.Find(LasVlr.SpecificationUser, LasVlr.ExtraBytesRecord);
            var fields = LasExtraBytes.Read(extra != null ? vlrs.Payload(extra) : new ByteReader(new byte[0], source.Path, 0),
                format.RecordBytes, header.RecordBytes, info);
            var layout = new LasRecordLayout(format, header.RecordBytes, fields);
            if (layout.DescribedBytes < header.RecordBytes)
                info.AddFact("extra bytes without a description", (header.RecordBytes - layout.DescribedBytes).ToString());
            info.Schema = layout.Schema;
            if (info.Schema.Has(AttributeNames.GpsTime))
                info.GpsTime = header.GpsTime;
            return new LasFile { Header = header, Vlrs = vlrs, Layout = layout, Info = info };
        }

        // WKT if it is readable, otherwise GeoTIFF keys: files with both have the keys for programs that cannot read WKT.
        static void ReadCrs(LasVlrTable vlrs, SourceInfo info)
        {
            info.Crs.GeoKeys = LasGeoKeys.ReadRecords(vlrs);
            var record = vlrs.Find(LasVlr.ProjectionUser, LasVlr.WktRecord);
            if (record != null && record.DataBytes > 0)
            {
                string wkt = Encoding.UTF8.GetString(vlrs.Payload(record).Bytes).TrimEnd('\0', ' ', '\n', '\r');
                if (WktCoordinateSystem.Read(wkt, info.Crs))
                    return;
                if (wkt.Length > 0)
                    info.Warn(record.DataOffset, "the CRS is no well-known text: left out");
            }
            LasGeoKeys.Read(vlrs, info, info.Crs);
        }
    }

    internal static class LasTransform
    {
        const double TypicalScale = 0.01;

        static readonly string[] s_axes = { "x", "y", "z" };

        // An axis whose scale is zero or not finite would lose its points, so it takes the scale of another axis (x and y each
        // other's first) or 0.01; an offset that is not finite becomes 0. Each of these is a warning. A negative scale is kept:
        // it mirrors, and that is exact.
        public static PositionTransform Read(LasHeader header, SourceInfo info)
        {
            var transform = new PositionTransform { Scale = header.Scale, Offset = header.Offset };
            for (int axis = 0; axis < 3; axis++)
            {
                double offset = header.Offset[axis];
                if (!IsFinite(offset))
                {
                    transform.Offset[axis] = 0;
                    info.Warn(LasHeader.At.Offset + 8 * axis, "offset of " + s_axes[axis] + ": wanted a number, got "
                        + NumberText.Of(offset) + ": read as 0");
                }
                double scale = header.Scale[axis];
                if (IsUsable(scale))
                    continue;
                double assumed = TypicalScale;
                for (int other = 2; other >= 0; other--)
                    if (other != axis && IsUsable(header.Scale[other]))
                        assumed = header.Scale[other];
                transform.Scale[axis] = assumed;
                info.Warn(LasHeader.At.Scale + 8 * axis, "scale of " + s_axes[axis] + ": wanted a number that is not 0, got "
                    + NumberText.Of(scale) + ": read as " + NumberText.Of(assumed));
            }
            return transform;
        }

        // A scale that moves a 32-bit integer beyond the doubles is as good as infinite.
        static bool IsUsable(double scale) => scale != 0 && IsFinite(scale) && IsFinite(scale * int.MinValue * 2);

        static bool IsFinite(double value) => !double.IsNaN(value) && !double.IsInfinity(value);
    }

    internal sealed class LasReader : RecordReader, ILasSource
    {
        readonly LasFile m_las;

        LasReader(LasFile las) : base(las.Info, new SourceHandle(las.Info.Path), las.Info.RecordBytes)
        {
            m_las = las;
            SetRecords(las.Layout.Fields, las.Header.PointsOffset, false, Info.PointsReadable);
        }

        internal static PointReader OpenUncompressed(LasFile las, RandomAccessFile source)
        {
            las.Info.PointsReadable = LasClaims.CountReadable(las.Header, source.Length, las.Info);
            LasClaims.CheckBounds(las.Header, source, las.Info.PointsReadable, las.Info);
            return new LasReader(las);
        }

        LasFile ILasSource.Las => m_las;

        public LasHeader Header => m_las.Header;
        public LasVlrTable Vlrs => m_las.Vlrs;
    }
}
