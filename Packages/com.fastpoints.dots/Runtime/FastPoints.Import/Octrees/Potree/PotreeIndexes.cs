using System;
using System.Globalization;
using FastPoints.Core;
using FastPoints.Reading;
using Unity.Mathematics;

namespace FastPoints.Octrees
{
    // What cloud.js and metadata.json have in common.
    static class PotreeIndexes
    {
        public static PotreeAttribute ReadAttribute(JsonMembers item, string elementsName, SourceInfo info)
        {
            long bytes = item.Long("size");
            if (bytes < 1 || bytes > PotreeAttribute.MaxElements * 8)
                throw item.Bad("size", "1 to " + PotreeAttribute.MaxElements * 8 + " bytes");
            long elements = item.Long(elementsName, 1);
            double[] scales = item.IsNumbers("scale", (int)Math.Max(1, Math.Min(elements, PotreeAttribute.MaxElements)))
                ? item.Numbers("scale", (int)elements) : null;
            double[] offsets = item.IsNumbers("offset", (int)Math.Max(1, Math.Min(elements, PotreeAttribute.MaxElements)))
                ? item.Numbers("offset", (int)elements) : null;
            if (scales != null && Array.IndexOf(scales, 0.0) >= 0)
                scales = null;
            var attribute = PotreeAttribute.Make(item.Text("name"), item.Text("type", ""), (int)bytes, scales, offsets,
                out string anomaly);
            if (anomaly != null)
                info.Warn(-1, anomaly);
            string description = item.Text("description", "");
            if (description.Length > 0)
                info.Fact("attribute " + attribute.Name, description);
            return attribute;
        }

        // No writer produces zero or negative ones.
        public static double3 UsableScale(double3 scale, JsonMembers json) =>
            math.all(scale > 0) ? scale : throw PointCloudException.Wanted(FailureCode.BadInput, json.Path, -1, "\"scale\"",
                "numbers above 0", NumberText.Of(scale));

        public static BoundsGeo Cube(BoundsGeo box, JsonMembers json) =>
            !box.IsEmpty ? box : throw PointCloudException.Wanted(FailureCode.BadInput, json.Path, -1, "\"boundingBox\"",
                "a box", "a maximum below the minimum");

        // Without one, 1/128 of the cube's edge, as converters use.
        public static double Spacing(JsonMembers json, BoundsGeo cube)
        {
            double spacing = json.Number("spacing", 0);
            return spacing > 0 ? spacing : math.cmax(cube.Size) / 128;
        }

        // Any kind of text: well-known text, a PROJ string, a code.
        public static void ReadProjection(JsonMembers json, SourceInfo info)
        {
            string text = json.Text("projection", "").Trim();
            if (text.Length == 0 || WktCoordinateSystem.Read(text, info.Crs))
                return;
            info.Crs.Name = text;
            if (text.StartsWith("EPSG:", StringComparison.OrdinalIgnoreCase) && int.TryParse(text.Substring(5), NumberStyles.None,
                CultureInfo.InvariantCulture, out int code))
                info.Crs.Epsg = code;
        }

        public static void AddFact(JsonMembers json, string name, SourceInfo info)
        {
            string text = json.Text(name, "");
            if (text.Length > 0)
                info.Fact(name, text);
        }
    }
}
