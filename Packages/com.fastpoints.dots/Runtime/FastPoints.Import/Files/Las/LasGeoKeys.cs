using System.Collections.Generic;
using System.Globalization;

namespace FastPoints.Files
{
    /// <summary>
    /// The GeoTIFF keys of a LAS file (GeoTIFF 1.0, sections 2.4 and 6): a directory of 16-bit entries, which point into a
    /// record of doubles and one of text. What is wrong with them is a warning, since points need no keys.
    /// </summary>
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
        const int VerticalTypeKey = 4096;

        const int GeographicModel = 2;
        const int UserDefined = 32767;
        const int EntryBytes = 8;

        /// <summary>EPSG unit codes and their lengths in metres (GeoTIFF 1.0, 6.3.1.3).</summary>
        static readonly Dictionary<int, double> s_metresOfUnit = new Dictionary<int, double>
        {
            { 9001, 1 }, { 9002, 0.3048 }, { 9003, 1200.0 / 3937 }, { 9005, 0.3047972654 }, { 9014, 1.8288 },
            { 9030, 1852 }, { 9036, 1000 }, { 9093, 1609.344 },
        };

        /// <summary>Fills <paramref name="crs"/> where the file has keys that say something.</summary>
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
                info.Warn(record.DataOffset, "GeoTIFF keys: wanted at least 8 bytes, got " + Text(directory.Length));
                return;
            }
            int version = directory.UInt16(0, "GeoTIFF key directory version");
            int count = directory.UInt16(6, "GeoTIFF key count");
            if (version != 1)
                info.Warn(record.DataOffset, "GeoTIFF keys: wanted directory version 1, got " + Text(version));
            if (!directory.Has(EntryBytes, count * EntryBytes))
            {
                int room = directory.Length / EntryBytes - 1;
                info.Warn(record.DataOffset + 6, "GeoTIFF keys: the directory claims " + Text(count) + " keys, there is room for "
                    + Text(room));
                count = room;
            }

            int model = 0, geographic = 0, projected = 0, unit = 0, empty = 0;
            double unitSize = 0;
            string name = null, citation = null;
            for (int i = 1; i <= count; i++)
            {
                int key = directory.UInt16(i * EntryBytes, "GeoTIFF key");
                int location = directory.UInt16(i * EntryBytes + 2, "GeoTIFF key location");
                int length = directory.UInt16(i * EntryBytes + 4, "GeoTIFF key count");
                int value = directory.UInt16(i * EntryBytes + 6, "GeoTIFF key value");
                long at = record.DataOffset + i * EntryBytes;
                switch (key)
                {
                    case 0:
                        empty++;
                        break;
                    case ModelTypeKey:
                        model = Code(location, value, key, at, info);
                        break;
                    case GeographicTypeKey:
                        geographic = Code(location, value, key, at, info);
                        break;
                    case ProjectedTypeKey:
                        projected = Code(location, value, key, at, info);
                        break;
                    case VerticalTypeKey:
                        crs.VerticalEpsg = Code(location, value, key, at, info);
                        break;
                    case LinearUnitsKey:
                        unit = Code(location, value, key, at, info);
                        break;
                    case LinearUnitSizeKey:
                        if (location == LasVlr.GeoDoubleParamsRecord && doubles.Has(8 * value, 8))
                            unitSize = doubles.Float64(8 * value, "GeoTIFF unit size");
                        else
                            Misplaced(key, location, value, at, info);
                        break;
                    case ProjectedCitationKey:
                        name = Citation(text, location, length, value, key, at, info);
                        break;
                    case CitationKey:
                    case GeographicCitationKey:
                        citation = citation ?? Citation(text, location, length, value, key, at, info);
                        break;
                }
            }
            if (empty > 0)
                info.Warn(record.DataOffset, "GeoTIFF key 0, which there is none of, stands " + Text(empty) + " times among "
                    + Text(count) + " keys: left out");
            crs.Epsg = projected != 0 ? projected : geographic;
            crs.Name = name ?? citation;
            if (model == GeographicModel || projected == 0 && geographic != 0 && unit == 0 && unitSize == 0)
                crs.MetresPerUnit = double.NaN;
            else if (unit != 0 && s_metresOfUnit.TryGetValue(unit, out double metres))
                crs.MetresPerUnit = metres;
            else if (unitSize > 0 && !double.IsInfinity(unitSize))
                crs.MetresPerUnit = unitSize;
            else if (IsUtm(projected))
                crs.MetresPerUnit = 1;
        }

        /// <summary>UTM zones on WGS 84 (north, south), ETRS89, NAD83, NAD27: metres, which files often do not say.</summary>
        static bool IsUtm(int epsg) =>
            epsg >= 32601 && epsg <= 32660 || epsg >= 32701 && epsg <= 32760 || epsg >= 25828 && epsg <= 25838
            || epsg >= 26901 && epsg <= 26923 || epsg >= 26701 && epsg <= 26722;

        static ByteReader PayloadOf(LasVlrTable vlrs, ushort recordId, ByteReader otherwise)
        {
            var record = vlrs.Find(LasVlr.ProjectionUser, recordId);
            return record != null
                ? vlrs.Payload(record)
                : new ByteReader(System.Array.Empty<byte>(), otherwise.Path, otherwise.FileOffset);
        }

        static int Code(int location, int value, int key, long at, SourceInfo info)
        {
            if (location != 0)
            {
                Misplaced(key, location, value, at, info);
                return 0;
            }
            return value == UserDefined ? 0 : value;
        }

        static string Citation(ByteReader text, int location, int length, int value, int key, long at, SourceInfo info)
        {
            if (location != LasVlr.GeoAsciiParamsRecord || !text.Has(value, length))
            {
                Misplaced(key, location, value, at, info);
                return null;
            }
            string citation = text.Text(value, length, "GeoTIFF citation").TrimEnd('|', ' ');
            return citation.Length > 0 ? citation : null;
        }

        static void Misplaced(int key, int location, int value, long at, SourceInfo info) =>
            info.Warn(at, "GeoTIFF key " + Text(key) + " points to " + Text(location) + "/" + Text(value)
                + ", where the file has nothing: left out");

        static string Text(long number) => number.ToString(CultureInfo.InvariantCulture);
    }
}
