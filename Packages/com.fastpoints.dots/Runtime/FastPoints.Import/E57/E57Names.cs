using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Reading;

namespace FastPoints.E57
{
    // What ASTM E2807 and its extension for normals name.
    static class E57Names
    {
        public const string CartesianInvalid = "cartesianInvalidState";
        public const string SphericalInvalid = "sphericalInvalidState";
        public const string ReturnIndex = "returnIndex";
        public const string Intensity = "intensity";

        public static readonly string[] Cartesian = { "cartesianX", "cartesianY", "cartesianZ" };
        public static readonly string[] Spherical = { "sphericalRange", "sphericalAzimuth", "sphericalElevation" };
        public static readonly string[] Colors = { "colorRed", "colorGreen", "colorBlue" };
        public static readonly string[] Normals = { "nor:normalX", "nor:normalY", "nor:normalZ" };

        static readonly Dictionary<string, string> s_attributes = new Dictionary<string, string>
        {
            { Intensity, AttributeNames.Intensity },
            { "colorRed", AttributeNames.Red },
            { "colorGreen", AttributeNames.Green },
            { "colorBlue", AttributeNames.Blue },
            { ReturnIndex, AttributeNames.ReturnNumber },
            { "returnCount", AttributeNames.NumberOfReturns },
            { "nor:normalX", AttributeNames.NormalX },
            { "nor:normalY", AttributeNames.NormalY },
            { "nor:normalZ", AttributeNames.NormalZ },
        };

        public static string AttributeOf(string field) =>
            s_attributes.TryGetValue(field, out string name) ? name : CommonNames.Of(field) ?? field;
    }
}
