using System.Text;
using FastPoints.Core;
using FastPoints.Reading;

namespace FastPoints.Las
{
    internal sealed class LasFile
    {
        public LasHeader Header { get; private set; }
        public LasVlrTable Vlrs { get; private set; }
        public LasRecordLayout Layout { get; private set; }

        // Complete except for PointsReadable and the claimed bounds: only the reader knows how points lie in the file.
        public SourceInfo Info { get; private set; }

        public static LasFile Read(FileSource source)
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
                info.Fact("extra bytes without a description", (header.RecordBytes - layout.DescribedBytes).ToString());
            info.Schema = layout.Schema;
            return new LasFile { Header = header, Vlrs = vlrs, Layout = layout, Info = info };
        }

        // WKT if it is readable, otherwise GeoTIFF keys: files with both have the keys for programs that cannot read WKT.
        static void ReadCrs(LasVlrTable vlrs, SourceInfo info)
        {
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
}
