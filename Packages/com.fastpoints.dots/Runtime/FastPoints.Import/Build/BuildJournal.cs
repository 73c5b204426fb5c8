using System;
using System.Collections.Generic;

namespace FastPoints.Build
{
    /// <summary>The progress of a build as far as it lies on disk, from which a killed build is continued. It converts from and
    /// to text, without I/O.</summary>
    internal sealed class BuildJournal
    {
        public enum Stage
        {
            Read, // Sources are read: up to Source and Block.
            Split, // All points are in chunks, which are split if they are too large.
            Index, // The chunks are final, and are indexed one by one.
            Done, // Everything is done except the folder's final name.
        }

        public struct Chunk
        {
            public GridCube Cube;
            public RecordRange[] Ranges;
        }

        const int Version = 3;
        public ulong Identity; // Identifies the sources, the settings and the partition: if they differ, it is another build.
        public Stage CurrentStage;
        public int Source; // The first source that is not read completely, and the first of its blocks that is not read.
        public int Block;

        public readonly List<PointStatistics> Statistics = new List<PointStatistics>();
        public AttributeStatistics[] Attributes = new AttributeStatistics[0];

        public readonly List<long> RecordCountOfFile = new List<long>();

        public readonly List<long> BlockBytesOfFile = new List<long>();
        public readonly List<Chunk> Chunks = new List<Chunk>(); // Present from Stage.Split on.
        public GridCube Root;

        public long[] BytesOfPlane = new long[0];
        public long PeakBytes;
        public int LevelCount;
        public long OwnBlockPoints; // See PartFilter.TakeOwnBlockPoints: of all that was read.

        public string ToJson()
        {
            var json = new JsonWriter().BeginObject().Add("version", Version).AddHex("identity", Identity).Add("stage",
                CurrentStage.ToString())
                .Add("source", Source).Add("block", Block).Add("peakBytes", PeakBytes)
                .Add("levelCount", LevelCount).Add("pointsWanted", OwnBlockPoints)
                .Add("rootCorner", Root.Corner.X, Root.Corner.Y, Root.Corner.Z).Add("rootSideLog2", Root.SideLog2);
            json.BeginArray("findings");
            foreach (var found in Statistics)
            {
                json.BeginObject().Add("count", found.Count).Add("leftOut", found.LeftOut)
                    .Add("min", found.Min.X, found.Min.Y, found.Min.Z).Add("max", found.Max.X, found.Max.Y, found.Max.Z)
                    .AddHex("checksum", found.Checksum).Add("worstLossSteps", found.MaxRoundingSteps).EndObject();
            }
            json.EndArray().BeginArray("attributes");
            foreach (var found in Attributes)
            {
                json.BeginObject().AddHex("min", found.OrderedMin).AddHex("max", found.OrderedMax).AddHex("or", found.Or)
                    .Add("notDoubled", found.Modulo257OrOfUInt16).EndObject();
            }
            json.EndArray().BeginArray("records");
            foreach (long count in RecordCountOfFile)
                json.Add(null, count);
            json.EndArray().BeginArray("recordBytes");
            foreach (long bytes in BlockBytesOfFile)
                json.Add(null, bytes);
            json.EndArray().BeginArray("chunks");
            foreach (var chunk in Chunks)
            {
                json.BeginObject().Add("corner", chunk.Cube.Corner.X, chunk.Cube.Corner.Y, chunk.Cube.Corner.Z)
                    .Add("sideLog2", chunk.Cube.SideLog2).BeginArray("runs");
                foreach (var range in chunk.Ranges)
                    json.Add(null, range.File, range.First, range.Count);
                json.EndArray().EndObject();
            }
            json.EndArray().BeginArray("bytesOfPlane");
            foreach (long bytes in BytesOfPlane)
                json.Add(null, bytes);
            return json.EndArray().EndObject().ToString();
        }

        /// <returns>Null if the text is not a journal of this version: the build then starts over.</returns>
        public static BuildJournal FromJson(string text)
        {
            try
            {
                var json = JsonMembers.Parse(text, "");
                json.RequireVersion(Version);
                return Read(json);
            }
            catch (Exception e) when (e is PointCloudException || e is OverflowException)
            {
                return null;
            }
        }

        static BuildJournal Read(JsonMembers json)
        {
            if (!Enum.TryParse(json.Text("stage"), out Stage stage))
                throw json.Wanted("stage", "a stage");
            var journal = new BuildJournal
            {
                Identity = json.Hex("identity"),
                CurrentStage = stage,
                Source = json.Int("source"),
                Block = json.Int("block"),
                PeakBytes = json.Long("peakBytes"),
                LevelCount = json.Int("levelCount"),
                OwnBlockPoints = json.Long("pointsWanted"),
                Root = new GridCube(ReadPosition(json, "rootCorner"), json.Int("rootSideLog2")),
                Attributes = json.Objects("attributes").ConvertAll(item => new AttributeStatistics
                {
                    OrderedMin = item.Hex("min"),
                    OrderedMax = item.Hex("max"),
                    Or = item.Hex("or"),
                    Modulo257OrOfUInt16 = (uint)item.NonNegative("notDoubled", uint.MaxValue),
                }).ToArray(),
                BytesOfPlane = json.Longs("bytesOfPlane"),
            };
            journal.Statistics.AddRange(json.Objects("findings").ConvertAll(item => new PointStatistics
            {
                Count = item.Long("count"),
                LeftOut = item.Long("leftOut"),
                Min = ReadPosition(item, "min"),
                Max = ReadPosition(item, "max"),
                Checksum = item.Hex("checksum"),
                MaxRoundingSteps = item.Number("worstLossSteps"),
            }));
            journal.RecordCountOfFile.AddRange(json.Longs("records"));
            journal.BlockBytesOfFile.AddRange(json.Longs("recordBytes"));
            foreach (var item in json.Objects("chunks"))
            {
                journal.Chunks.Add(new Chunk
                {
                    Cube = new GridCube(ReadPosition(item, "corner"), item.Int("sideLog2")),
                    Ranges = item.LongLists("runs", 3).ConvertAll(range => new RecordRange
                    {
                        File = checked((int)range[0]),
                        First = range[1],
                        Count = range[2],
                    }).ToArray(),
                });
            }
            return journal;
        }

        static Grid3 ReadPosition(JsonMembers json, string name)
        {
            long[] steps = json.Longs(name, 3);
            return new Grid3(steps[0], steps[1], steps[2]);
        }
    }

    internal struct RecordRange
    {
        public int File;
        public long First;
        public long Count;
    }
}
