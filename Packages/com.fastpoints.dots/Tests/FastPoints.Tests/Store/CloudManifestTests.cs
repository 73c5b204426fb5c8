using FastPoints.Store;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Store
{
    [Category("Smoke")]
    public class CloudManifestTests
    {
        static CloudManifest Example()
        {
            var manifest = new CloudManifest
            {
                CloudId = 0xFEDCBA9876543210UL,
                Points = 1L << 40,
                PointsLeftOut = 3,
                Checksum = ulong.MaxValue,
                Grid = new CloudGrid
                {
                    Origin = new double3(1e7, -0.1, 1.0 / 3),
                    Step = new double3(1e-4, 0.01, math.pow(2.0, -30))
                },
                Root = new GridCube(new Grid3(-5, 1L << 60, 0), 43),
                BoundsMin = new Grid3(-1, 2, 3),
                BoundsMax = new Grid3(1L << 59, 5, 6),
                Attributes = new PointSchema(new[]
                {
                    new PointAttribute("Red", AttributeType.UInt16),
                    new PointAttribute("odd \"name\"\n\\", AttributeType.Float64, 0.1, -7),
                }),
                Divisors = new[] { 257, 1 },
                Ranges = new[] { new CloudManifest.ValueRange { Min = 0, Max = 65535 }, new CloudManifest.ValueRange
                    { Min = double.NaN, Max = double.NaN } },
                MetresPerUnit = double.NaN,
                CrsName = "EPSG:26910",
                DisplayRanges = new StoredDisplayRanges
                {
                    BoundsGeo = new BoundsGeo(new double3(-1, 0.1, 2), new double3(1e7, 3, 4)),
                    Elevation = new CloudManifest.ValueRange { Min = 2.5, Max = 3.75 },
                    Intensity = new CloudManifest.ValueRange { Min = 7, Max = 900 },
                    HasColor = true,
                },
                HierarchyFileBytes = 12345,
                RootOffset = 1L << 40,
                RootBytes = 65536,
                RootHash = 42,
            };
            return manifest;
        }

        [Test]
        public void ToJson_ReadBack_IsTheSame()
        {
            string json = Example().ToJson();
            var back = CloudManifest.FromJson(json, "cloud.json");
            Assert.That(back.ToJson(), Is.EqualTo(json));
            Assert.That(back.Points, Is.EqualTo(1L << 40));
            Assert.That(back.Checksum, Is.EqualTo(ulong.MaxValue));
            Assert.That(back.Grid.Origin.z, Is.EqualTo(1.0 / 3));
            Assert.That(back.Attributes[1].Name, Is.EqualTo("odd \"name\"\n\\"));
            Assert.That(back.Divisors[0], Is.EqualTo(257));
            Assert.That(back.DisplayRanges, Is.EqualTo(Example().DisplayRanges));
            Assert.That(back.RootPage, Is.EqualTo(Example().RootPage));
        }

        [Test]
        public void FromJson_WithoutDisplayRanges_IsRead()
        {
            var manifest = Example();
            manifest.DisplayRanges = null;
            string json = manifest.ToJson();
            Assert.That(json, Does.Not.Contain("shown"));
            Assert.That(CloudManifest.FromJson(json, "cloud.json").DisplayRanges, Is.Null);
        }

        [Test]
        public void ToJson_EveryPowerOfTwo_ReadsBackTheSame()
        {
            for (int exponent = -1000; exponent < 1000; exponent++)
            {
                double value = System.Math.Pow(2, exponent);
                string json = new JsonWriter().BeginArray().Add(null, value).EndArray().ToString();
                Assert.That(JsonReader.ToDouble(((System.Collections.Generic.List<object>)JsonReader.Parse(json))[0]),
                    Is.EqualTo(value));
            }
        }

        [TestCase("\"points\": 1099511627776", "\"points\": -1", "\"points\"")]
        [TestCase("\"points\": 1099511627776", "\"points\": 1.5", "\"points\"")]
        [TestCase("\"points\": 1099511627776", "\"points\": \"1\"", "\"points\"")]
        [TestCase("\"pointsLeftOut\"", "\"left\"", "\"pointsLeftOut\"")]
        [TestCase("\"sideLog2\": 43", "\"sideLog2\": 63", "\"sideLog2\"")]
        [TestCase("\"Float64\"", "\"Float65\"", "Float65")]
        [TestCase("\"divisor\": 257", "\"divisor\": 0", "\"divisor\"")]
        [TestCase("\"elevationMax\": 3.75", "\"elevationMax\": \"high\"", "\"elevationMax\"")]
        [TestCase("\"intensityMin\"", "\"intensity\"", "\"intensityMin\"")]
        [TestCase("\"version\": 3", "\"version\": 4", "version")]
        [TestCase("\"rootBytes\": 65536", "\"rootBytes\": 4294967296", "\"rootBytes\"")]
        [TestCase("\"kind\": \"source\"", "\"kind\": \"normal\"", "0 to be source position, got normal")]
        [TestCase("\"format\": \"fastpoints\"", "\"format\": \"potree\"", "\"format\"")]
        [TestCase("{", "[", "character")]
        public void FromJson_InvalidMember_NamesIt(string good, string bad, string named)
        {
            string json = Example().ToJson();
            int at = json.IndexOf(good, System.StringComparison.Ordinal);
            Assert.That(at, Is.GreaterThanOrEqualTo(0));
            string broken = json.Substring(0, at) + bad + json.Substring(at + good.Length);
            Assert.That(() => CloudManifest.FromJson(broken, "cloud.json"),
                Throws.TypeOf<PointCloudException>().With.Message.Contains(named).And.Message.Contains("cloud.json"));
        }

        [TestCase(""), TestCase("{"), TestCase("{\"a\": 01}"), TestCase("{\"a\": 1,}"), TestCase("{\"a\": 1} x")]
        [TestCase("{\"a\": \"\\x\"}"), TestCase("{\"a\": 1, \"a\": 2}"), TestCase("nul")]
        public void Parse_InvalidJson_Throws(string text) =>
            Assert.That(() => JsonReader.Parse(text), Throws.TypeOf<System.FormatException>());

        [Test]
        public void Parse_ManyLevels_ThrowsBeforeTheStackEnds() =>
            Assert.That(() => JsonReader.Parse(new string('[', 100000)), Throws.TypeOf<System.FormatException>());
    }
}
