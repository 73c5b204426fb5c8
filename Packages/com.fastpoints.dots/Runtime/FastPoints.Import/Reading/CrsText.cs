using System;
using System.Collections.Generic;
using System.Globalization;

namespace FastPoints.Reading
{
    // Coordinate systems as users and octrees write them: well-known text, PROJ strings, EPSG codes. What they do not state
    // comes from EPSG's table.
    internal static class CrsText
    {
        const double UsFoot = 1200.0 / 3937;
        const double MaxPlacementError = 0.1; // Metres.
        const double Rounding = 1e-7; // Of units in texts; the two feet differ by 2e-6.

        // PROJ's names of units ("proj -lu").
        static readonly Dictionary<string, double> s_metresOfUnit = new Dictionary<string, double>
        {
            { "m", 1 }, { "km", 1000 }, { "dm", 0.1 }, { "cm", 0.01 }, { "mm", 0.001 }, { "kmi", 1852 }, { "in", 0.0254 },
            { "ft", 0.3048 }, { "yd", 0.9144 }, { "mi", 1609.344 }, { "fath", 1.8288 }, { "ch", 20.1168 }, { "link", 0.201168 },
            { "us-in", UsFoot / 12 }, { "us-ft", UsFoot }, { "us-yd", UsFoot * 3 }, { "us-ch", UsFoot * 66 },
            { "us-mi", UsFoot * 5280 }, { "ind-yd", 0.91439523 }, { "ind-ft", 0.30479841 }, { "ind-ch", 20.11669506 },
        };

        /// <summary>Metres of a unit by PROJ's name of it or by their number, also as a fraction; 0 for anything else.</summary>
        public static double MetresOfUnit(string text)
        {
            if (s_metresOfUnit.TryGetValue(text, out double metres))
                return metres;
            int slash = text.IndexOf('/');
            double below = 1;
            bool isNumber = NumberText.TryRead(slash < 0 ? text : text.Substring(0, slash), out metres) &&
                (slash < 0 || NumberText.TryRead(text.Substring(slash + 1), out below));
            metres /= below;
            return isNumber && metres > 0 && metres <= double.MaxValue ? metres : 0;
        }

        // False if it is none of them; nothing is filled in then.
        public static bool Read(string text, CoordinateSystem crs)
        {
            text = text.Trim();
            return ReadCodes(text, crs) || ReadProj(text, crs) || WktCoordinateSystem.Read(text, crs);
        }

        /// <summary>Warns if a flat map of the whole cloud misplaces coordinates in degrees.</summary>
        public static void WarnOfPlacement(SourceInfo info)
        {
            double error = info.Crs.Units.PlacementError(info.BoundsIfFinite);
            if (error > MaxPlacementError)
                info.Warn(-1, "coordinates are in degrees: shown in metres around the centre, corners are " +
                    error.ToString("G2", CultureInfo.InvariantCulture) + " m wrong; a projected copy would be exact");
        }

        /// <summary>Adds what EPSG's table knows and the file does not state.</summary>
        public static void Complete(SourceInfo info)
        {
            var crs = info.Crs;
            var system = crs.Epsg != 0 ? EpsgTable.Find(crs.Epsg) : null;
            if (system != null)
            {
                crs.Name ??= EpsgTable.NameOf(system);
                crs.Axes ??= system.Axes;
                if (crs.Kind == CrsKind.Unknown)
                    crs.Kind = system.Kind;
                if (crs.VerticalMetresPerUnit == 0)
                    crs.VerticalMetresPerUnit = system.VerticalMetresPerUnit;
                double stated = crs.MetresPerUnit, known = system.MetresPerUnit;
                if (stated == 0)
                    crs.MetresPerUnit = known;
                else if (known != 0 && double.IsNaN(stated) == double.IsNaN(known) && Math.Abs(stated - known) > Rounding * known)
                    info.Warn(-1, "the unit of EPSG:" + crs.Epsg + " is " + NumberText.Of(known) + " m, the file says " +
                        NumberText.Of(stated) + " m: the file is followed");
            }
            if (crs.VerticalEpsg != 0 && crs.VerticalMetresPerUnit == 0)
                crs.VerticalMetresPerUnit = EpsgTable.Find(crs.VerticalEpsg)?.VerticalMetresPerUnit ?? 0;
        }

        // EPSG:2229, EPSG:2229+5703, urn:ogc:def:crs:EPSG::2229, and such of several parts.
        static bool ReadCodes(string text, CoordinateSystem crs)
        {
            string codes = text.ToUpperInvariant();
            bool isUrn = codes.StartsWith("URN:OGC:DEF:CRS", StringComparison.Ordinal);
            if (!isUrn && !codes.StartsWith("EPSG:", StringComparison.Ordinal))
                return false;
            string[] parts = isUrn ? codes.Substring("URN:OGC:DEF:CRS".Length).TrimStart(',').Split(',')
                : codes.Substring("EPSG:".Length).Split('+');
            var found = new int[parts.Length];
            for (int i = 0; i < parts.Length; i++)
            {
                string code = parts[i].Substring(parts[i].LastIndexOf(':') + 1);
                if (isUrn && parts[i].IndexOf(":EPSG:", StringComparison.Ordinal) < 0 || !int.TryParse(code, NumberStyles.None,
                    CultureInfo.InvariantCulture, out found[i]))
                    return false;
            }
            if (found.Length > 2)
                return false;
            crs.Epsg = found[0];
            crs.VerticalEpsg = found.Length > 1 ? found[1] : 0;
            return true;
        }

        static bool ReadProj(string text, CoordinateSystem crs)
        {
            if (!text.StartsWith("+", StringComparison.Ordinal))
                return false;
            crs.Name = text;
            double unit = 0;
            foreach (string part in text.Split(new[] { ' ', '\t', '\n', '\r' }, StringSplitOptions.RemoveEmptyEntries))
            {
                int equals = part.IndexOf('=');
                string value = equals < 0 ? "" : part.Substring(equals + 1);
                switch (equals < 0 ? part : part.Substring(0, equals))
                {
                    case "+proj":
                        crs.Kind = value == "longlat" || value == "latlong" || value == "latlon" || value == "lonlat"
                            ? CrsKind.Geographic : value == "geocent" ? CrsKind.Geocentric : CrsKind.Projected;
                        break;
                    case "+init":
                        ReadCodes(value, crs);
                        break;
                    case "+units":
                    case "+to_meter":
                        unit = MetresOfUnit(value);
                        break;
                    case "+vunits":
                    case "+vto_meter":
                        crs.VerticalMetresPerUnit = MetresOfUnit(value);
                        break;
                }
            }
            // Metres are what PROJ takes where nothing is said.
            crs.MetresPerUnit = crs.Kind == CrsKind.Geographic ? double.NaN : unit != 0 ? unit
                : crs.Kind != CrsKind.Unknown && text.IndexOf("+units", StringComparison.Ordinal) < 0 ? 1 : 0;
            return true;
        }
    }
}
