using System.Collections.Generic;
using System.Text;

namespace FastPoints.Reading
{
    // LAS's attributes by the names that writers of PLY, PCD, E57 and text give them: scalar_Classification, las:gpsTime.
    static class CommonNames
    {
        static readonly Dictionary<string, string> s_names = new Dictionary<string, string>
        {
            { "class", AttributeNames.Classification }, { "scananglerank", AttributeNames.ScanAngle },
            { "nir", AttributeNames.NearInfrared }, { "infrared", AttributeNames.NearInfrared },
        };

        static CommonNames()
        {
            foreach (string name in new[]
            {
                AttributeNames.Classification, AttributeNames.ReturnNumber, AttributeNames.NumberOfReturns,
                AttributeNames.ScanDirectionFlag, AttributeNames.EdgeOfFlightLine, AttributeNames.Synthetic,
                AttributeNames.KeyPoint, AttributeNames.Withheld, AttributeNames.Overlap, AttributeNames.ScannerChannel,
                AttributeNames.ScanAngle, AttributeNames.UserData, AttributeNames.PointSourceId, AttributeNames.GpsTime,
                AttributeNames.NearInfrared,
            })
                s_names.Add(name.ToLowerInvariant(), name);
        }

        // Null if LAS has none of that name. Ignores case, blanks, underscores and writers' prefixes.
        public static string Of(string name)
        {
            var plain = new StringBuilder(name.Length);
            foreach (char c in name.StartsWith("las:", System.StringComparison.Ordinal) ? name.Substring(4) : name)
                if (c != '_' && c != ' ')
                    plain.Append(char.ToLowerInvariant(c));
            if (name.StartsWith("scalar_", System.StringComparison.OrdinalIgnoreCase))
                plain.Remove(0, "scalar".Length);
            return s_names.TryGetValue(plain.ToString(), out string typical) ? typical : null;
        }
    }
}
