using System.Collections.Generic;
using FastPoints.Reading;

namespace FastPoints.Las
{
    // The GeoTIFF keys of a LAS file (GeoTIFF 1.0, sections 2.4 and 6): a directory of 16-bit entries, which point into a record
    // of doubles and one of text. Errors in them are warnings, since points need no keys.
    internal static class LasGeoKeys
    {
        const int ModelTypeKey = 1024;
        const int CitationKey = 1026;
        const int GeographicTypeKey = 2048;
        const int GeographicCitationKey = 2049;
        const int ProjectedTypeKey = 3072;
        const int ProjectedCitationKey = 3073;
        const int LinearUnitsKey = 3076;
        const int LinearUnitSizeKey = 3077;
        const int AngularUnitsKey = 2054;
        const int VerticalTypeKey = 4096;
        const int VerticalUnitsKey = 4099;

        const int ProjectedModel = 1;
        const int GeographicModel = 2;
        const int GeocentricModel = 3;
        const int UserDefined = 32767;
        const int EntryBytes = 8;

        public static readonly ushort[] RecordIds =
            { LasVlr.GeoKeyDirectoryRecord, LasVlr.GeoDoubleParamsRecord, LasVlr.GeoAsciiParamsRecord };

        public static void Read(LasVlrTable vlrs, SourceInfo info, CoordinateSystem crs)
        {
            var record = vlrs.Find(LasVlr.ProjectionUser, LasVlr.GeoKeyDirectoryRecord);
            if (record == null || record.DataBytes == 0)
                return;
            var directory = vlrs.Payload(record);
            var doubles = PayloadOf(vlrs, LasVlr.GeoDoubleParamsRecord, directory);
            var text = PayloadOf(vlrs, LasVlr.GeoAsciiParamsRecord, directory);
            if (!directory.Has(0, EntryBytes))
            {
                info.Warn(record.DataOffset, "GeoTIFF keys: wanted at least 8 bytes, got " + NumberText.Of(directory.Length));
                return;
            }
            int count = CountOf(directory, record, info);
            var keys = new Keys { VerticalEpsg = crs.VerticalEpsg };
            for (int i = 1; i <= count; i++)
                keys.Read(new Key(i, directory, record.DataOffset, info), doubles, text);
            if (keys.EmptyKeys > 0)
                info.Warn(record.DataOffset, "GeoTIFF key 0, which there is none of, stands " + NumberText.Of(keys.EmptyKeys)
                    + " times among " + NumberText.Of(count) + " keys: left out");
            keys.Fill(crs);
        }

        /// <summary>The three records unchanged, empty if missing. Null without a directory, or if one is too long to
        /// be written again.</summary>
        public static byte[][] ReadRecords(LasVlrTable vlrs)
        {
            var records = System.Array.ConvertAll(RecordIds, id => vlrs.Find(LasVlr.ProjectionUser, id));
            if (!(records[0]?.DataBytes > 0) || System.Array.Exists(records, r => r?.DataBytes > ushort.MaxValue))
                return null;
            return System.Array.ConvertAll(records, r => r != null ? vlrs.Payload(r).Bytes : System.Array.Empty<byte>());
        }

        public static byte[] Directory(CoordinateSystem crs)
        {
            bool isGeographic = double.IsNaN(crs.MetresPerUnit);
            var keys = new List<(int Key, int Value)>();
            if (crs.Epsg != 0)
            {
                keys.Add((ModelTypeKey, isGeographic ? GeographicModel : 1));
                keys.Add((isGeographic ? GeographicTypeKey : ProjectedTypeKey, crs.Epsg));
            }
            if (crs.VerticalEpsg != 0)
                keys.Add((VerticalTypeKey, crs.VerticalEpsg));
            var directory = new byte[EntryBytes * (1 + keys.Count)];
            LasHeader.Put(directory, 0, 2, 1);
            LasHeader.Put(directory, 2, 2, 1);
            LasHeader.Put(directory, 6, 2, (ulong)keys.Count);
            for (int i = 0; i < keys.Count; i++)
            {
                LasHeader.Put(directory, EntryBytes * (i + 1), 2, (ulong)keys[i].Key);
                LasHeader.Put(directory, EntryBytes * (i + 1) + 4, 2, 1);
                LasHeader.Put(directory, EntryBytes * (i + 1) + 6, 2, (ulong)keys[i].Value);
            }
            return directory;
        }

        static int CountOf(ByteReader directory, LasVlr record, SourceInfo info)
        {
            int version = directory.UInt16(0, "GeoTIFF key directory version");
            int count = directory.UInt16(6, "GeoTIFF key count");
            if (version != 1)
                info.Warn(record.DataOffset, "GeoTIFF keys: wanted directory version 1, got " + NumberText.Of(version));
            if (directory.Has(EntryBytes, count * EntryBytes))
                return count;
            int room = directory.Length / EntryBytes - 1;
            info.Warn(record.DataOffset + 6, "GeoTIFF keys: the directory claims " + NumberText.Of(count)
                + " keys, there is room for " + NumberText.Of(room));
            return room;
        }

        // 0 and null where the keys say nothing.
        struct Keys
        {
            public int EmptyKeys;
            public int VerticalEpsg;
            int m_model;
            int m_geographic;
            int m_projected;
            bool m_isProjected;
            int m_unit;
            int m_angularUnit;
            int m_verticalUnit;
            double m_unitSize;
            string m_name;
            string m_citation;

            public void Read(Key key, ByteReader doubles, ByteReader text)
            {
                switch (key.Id)
                {
                    case 0:
                        EmptyKeys++;
                        break;
                    case ModelTypeKey:
                        m_model = key.Code();
                        break;
                    case GeographicTypeKey:
                        m_geographic = key.Code();
                        break;
                    case ProjectedTypeKey:
                        m_projected = key.Code();
                        m_isProjected = key.Location == 0 && key.Value != 0;
                        break;
                    case VerticalTypeKey:
                        VerticalEpsg = key.Code();
                        break;
                    case AngularUnitsKey:
                        m_angularUnit = key.Code();
                        break;
                    case VerticalUnitsKey:
                        m_verticalUnit = key.Code();
                        break;
                    case LinearUnitsKey:
                        m_unit = key.Code();
                        break;
                    case LinearUnitSizeKey:
                        if (key.Location == LasVlr.GeoDoubleParamsRecord && doubles.Has(8 * key.Value, 8))
                            m_unitSize = doubles.Float64(8 * key.Value, "GeoTIFF unit size");
                        else
                            key.WarnMisplaced();
                        break;
                    case ProjectedCitationKey:
                        m_name = key.Citation(text);
                        break;
                    case CitationKey:
                    case GeographicCitationKey:
                        m_citation ??= key.Citation(text);
                        break;
                }
            }

            public void Fill(CoordinateSystem crs)
            {
                // In projected and geocentric systems the geographic key names their base system.
                bool isDerived = m_model == ProjectedModel || m_model == GeocentricModel || m_model == 0 && m_isProjected;
                crs.Epsg = isDerived ? m_projected : m_geographic;
                crs.VerticalEpsg = VerticalEpsg;
                crs.Name = m_name ?? m_citation;
                crs.Kind = m_model == GeocentricModel ? CrsKind.Geocentric : m_isProjected || m_model == ProjectedModel
                    ? CrsKind.Projected : m_geographic != 0 || m_model == GeographicModel ? CrsKind.Geographic : CrsKind.Unknown;
                double linear = m_unitSize > 0 && !double.IsInfinity(m_unitSize) ? m_unitSize : 0;
                linear = EpsgTable.MetresPerUnit(m_unit) is double metres && metres > 0 ? metres : linear;
                if (m_model == GeographicModel || !isDerived && m_geographic != 0 && linear == 0)
                    crs.MetresPerUnit = m_angularUnit == 0 ? double.NaN : EpsgTable.MetresPerUnit(m_angularUnit);
                else
                    crs.MetresPerUnit = linear == 0 && m_model == GeocentricModel ? 1 : linear;
                double vertical = EpsgTable.MetresPerUnit(m_verticalUnit);
                crs.VerticalMetresPerUnit = vertical > 0 ? vertical : 0;
            }
        }

        static ByteReader PayloadOf(LasVlrTable vlrs, ushort recordId, ByteReader directory)
        {
            var record = vlrs.Find(LasVlr.ProjectionUser, recordId);
            return record != null
                ? vlrs.Payload(record)
                : new ByteReader(System.Array.Empty<byte>(), directory.Path, directory.FileOffset);
        }

        readonly struct Key
        {
            public readonly int Id, Location, Length, Value;
            readonly long m_at;
            readonly SourceInfo m_info;

            public Key(int entry, ByteReader directory, long offset, SourceInfo info)
            {
                int at = entry * EntryBytes;
                Id = directory.UInt16(at, "GeoTIFF key");
                Location = directory.UInt16(at + 2, "GeoTIFF key location");
                Length = directory.UInt16(at + 4, "GeoTIFF key count");
                Value = directory.UInt16(at + 6, "GeoTIFF key value");
                m_at = offset + at;
                m_info = info;
            }

            public int Code()
            {
                if (Location != 0)
                    WarnMisplaced();
                return Location != 0 || Value == UserDefined ? 0 : Value;
            }

            public string Citation(ByteReader text)
            {
                bool isThere = Location == LasVlr.GeoAsciiParamsRecord && text.Has(Value, Length);
                if (!isThere)
                    WarnMisplaced();
                string citation = isThere ? text.Text(Value, Length, "GeoTIFF citation").TrimEnd('|', ' ') : "";
                return citation.Length > 0 ? citation : null;
            }

            public void WarnMisplaced() => m_info.Warn(m_at, "GeoTIFF key " + NumberText.Of(Id) + " points to "
                + NumberText.Of(Location) + "/" + NumberText.Of(Value) + ", where the file has nothing: left out");
        }
    }
}
