using FastPoints.Base;
using FastPoints.Files;
using FastPoints.Points;

namespace FastPoints.Preview
{
    /// <summary>What a preview keeps of each point: its position and what it can be coloured by.</summary>
    public static class SampleSchema
    {
        /// <exception cref="PointCloudException">The source has no positions.</exception>
        public static PointSchema Of(SourceInfo info)
        {
            var schema = info.Schema.Select(AttributeNames.X, AttributeNames.Y, AttributeNames.Z, AttributeNames.Intensity,
                AttributeNames.Classification, AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue);
            if (!schema.Has(AttributeNames.X) || !schema.Has(AttributeNames.Y) || !schema.Has(AttributeNames.Z))
                throw new PointCloudException(FailureCode.Unsupported, info.Path, -1,
                    "nothing to draw: wanted attributes X, Y and Z, got " + info.Schema);
            return schema;
        }
    }
}
