using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Reading;
using Unity.Mathematics;

namespace FastPoints.Octrees
{
    sealed class Potree2Index
    {
        public SourceInfo Info { get; private set; }
        public PotreeLayout Layout { get; private set; }
        public BoundsGeo Cube { get; private set; }
        public double Spacing { get; private set; }
        public long FirstChunkBytes { get; private set; }
        public bool IsBrotli { get; private set; }

        public static Potree2Index Read(JsonMembers json)
        {
            string encoding = json.Text("encoding");
            if (encoding != "DEFAULT" && encoding != "BROTLI" && encoding != "UNCOMPRESSED")
                throw PointCloudException.Wanted(FailureCode.Unsupported, json.Path, -1, "encoding", "DEFAULT or BROTLI",
                    encoding);
            var info = new SourceInfo
            {
                Path = json.Path,
                FileBytes = json.FileBytes,
                Format = "Potree",
                Version = json.Text("version", "2"),
                PointsClaimed = (ulong)System.Math.Max(0, json.Long("points", 0)),
            };
            info.Transform.Scale = PotreeIndexes.UsableScale(json.Vector("scale"), json);
            info.Transform.Offset = json.Vector("offset");
            var box = json.Object("boundingBox");
            var index = new Potree2Index
            {
                Info = info,
                Cube = PotreeIndexes.Cube(new BoundsGeo(box.Vector("min"), box.Vector("max")), json),
                IsBrotli = encoding == "BROTLI",
                FirstChunkBytes = json.Object("hierarchy").Long("firstChunkSize"),
            };
            index.Spacing = PotreeIndexes.Spacing(json, index.Cube);
            index.Layout = new PotreeLayout(ReadAttributes(json, info), json.Path);
            info.Schema = index.Layout.Schema;
            info.RecordBytes = index.IsBrotli ? 0 : index.Layout.RecordBytes;
            info.HasBoundsClaimed = true;
            PotreeIndexes.ReadProjection(json, info);
            PotreeIndexes.AddFact(json, "name", info);
            PotreeIndexes.AddFact(json, "description", info);
            info.Fact("encoding", encoding);
            info.Fact("spacing", NumberText.Of(index.Spacing));
            return index;
        }

        static List<PotreeAttribute> ReadAttributes(JsonMembers json, SourceInfo info)
        {
            var attributes = new List<PotreeAttribute>();
            var box = json.Object("boundingBox");
            info.BoundsClaimed = new BoundsGeo(box.Vector("min"), box.Vector("max"));
            foreach (var item in json.Objects("attributes"))
            {
                var attribute = PotreeIndexes.ReadAttribute(item, "numElements", info);
                if (attribute.IsPosition && item.IsNumbers("min", 3) && item.IsNumbers("max", 3))
                    TightenBounds(new BoundsGeo(item.Vector("min"), item.Vector("max")), info);
                attributes.Add(attribute);
            }
            return attributes;
        }

        // The position's range is that of the points, the bounding box is the cube around them.
        static void TightenBounds(BoundsGeo range, SourceInfo info)
        {
            var step = info.Transform.Scale;
            if (!range.IsEmpty && math.all(range.Max <= info.BoundsClaimed.Max + step)
                && math.all(range.Min >= info.BoundsClaimed.Min - step))
                info.BoundsClaimed = range;
        }
    }
}
