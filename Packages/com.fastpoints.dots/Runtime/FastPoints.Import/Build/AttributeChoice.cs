using System;
using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Reading;

namespace FastPoints.Build
{
    /// <summary>Chooses which attributes of its sources a cloud keeps.</summary>
    internal static class AttributeChoice
    {
        /// <summary>The first source's attributes except its position. Every source must have the same ones.</summary>
        /// <param name="names">Names of the wanted ones; null for all.</param>
        /// <exception cref="PointCloudException">A source has no position, or lacks one of the attributes.</exception>
        public static PointSchema Of(IReadOnlyList<PointReader> readers, string[] names)
        {
            var chosen = new List<PointAttribute>();
            foreach (var attribute in readers[0].Info.Schema)
            {
                bool isPosition = attribute.Name == AttributeNames.X || attribute.Name == AttributeNames.Y ||
                    attribute.Name == AttributeNames.Z;
                if (!isPosition && (names == null || Array.IndexOf(names, attribute.Name) >= 0))
                    chosen.Add(attribute);
            }
            foreach (var reader in readers)
            {
                var schema = reader.Info.Schema;
                foreach (string axis in new[] { AttributeNames.X, AttributeNames.Y, AttributeNames.Z })
                {
                    if (!schema.Has(axis))
                        throw new PointCloudException(FailureCode.Unsupported, reader.Info.Path, -1, "no " + axis);
                }
                foreach (var attribute in chosen)
                {
                    int column = schema.IndexOf(attribute.Name);
                    if (column < 0 || !schema[column].Equals(attribute))
                        throw PointCloudException.Wanted(FailureCode.Unsupported, reader.Info.Path, -1,
                            "an attribute of the first file", attribute, column < 0 ? "none" : schema[column].ToString());
                }
            }
            return new PointSchema(chosen);
        }
    }
}
