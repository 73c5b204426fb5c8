using System.IO;
using System.Linq;
using System.Text.Json;
using FastPoints.Cli;
using FastPoints.Picture;
using NUnit.Framework;

namespace FastPoints.HostTests.Cli
{
    public sealed class FlyTests
    {
        const int Points = 30_000;

        ScratchFolder m_scratch;
        string m_cloud;

        [OneTimeSetUp]
        public void MakeCloud()
        {
            m_scratch = new ScratchFolder();
            m_cloud = m_scratch["scan.fastpoints"];
            var call = CliCall.Of("convert", m_scratch.Demo(points: Points), "-o", m_cloud, "--quiet");
            Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        }

        [OneTimeTearDown]
        public void RemoveCloud() => m_scratch.Dispose();

        [Test]
        public void Fly_TwoClouds_WritesPicturesFramesAndTheKeys()
        {
            string folder = m_scratch["flight"];
            var call = CliCall.Of("fly", m_cloud, m_cloud, "--frames", "40", "--every", "10", "--size", "160x90", "-o", folder, "--json", "-");
            Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
            var json = call.Json;
            foreach (string key in new[] { "frames", "garbageBytes", "pointsDrawn", "bytesRead", "secondsToFull", "hitches", "disposeMs" })
                Assert.That(json.GetProperty(key).ValueKind, Is.EqualTo(JsonValueKind.Number), key);
            foreach (string key in new[] { "frameMs", "mainThreadMs" })
                foreach (string part in new[] { "p50", "p99", "max" })
                    Assert.That(json.GetProperty(key).GetProperty(part).GetDouble(), Is.GreaterThan(0), key);
            Assert.That(json.GetProperty("frames").GetInt32(), Is.EqualTo(40));
            Assert.That(json.GetProperty("pointsDrawn").GetInt64(), Is.InRange(1, 2 * Points));
            Assert.That(json.GetProperty("cuts").EnumerateArray().First().GetProperty("frame").GetInt32(), Is.Zero);
            Assert.That(File.ReadLines(Path.Combine(folder, "frames.csv")).Count(), Is.EqualTo(41));
            var last = Png.Read(Path.Combine(folder, "last.png"));
            Assert.That(last.Rgba.Distinct().Count(), Is.GreaterThan(10), "the picture is empty");
            var first = Png.Read(Path.Combine(folder, "flight.png"));
            Assert.That((first.Width, first.Height), Is.EqualTo((160, 90)));
        }

        [Test]
        public void Fly_PathOfOnesOwn_HasItsFramesAndCuts()
        {
            string path = m_scratch["way.txt"];
            File.WriteAllText(path, "# a comment\n0 -50 -50 30 0 0 0\n10, 50,-50,30, 0,0,0\n12 0 0 5 10 10 0 cut\n20 1 0 5 10 10 0\n");
            var call = CliCall.Of("fly", m_cloud, "--path", path, "--json", "-");
            Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
            Assert.That(call.Json.GetProperty("frames").GetInt32(), Is.EqualTo(21));
            Assert.That(call.Json.GetProperty("cuts").EnumerateArray().Select(c => c.GetProperty("frame").GetInt32()),
                Is.EqualTo(new[] { 0, 12 }));
        }

        [Test]
        public void Fly_FewerFramesThanAPictureTakes_DrawsTheLast()
        {
            string folder = m_scratch["short"];
            Assert.That(CliCall.Of("fly", m_cloud, "--frames", "3", "--every", "10", "--size", "32x18", "-o", folder).Status,
                Is.EqualTo(ExitStatus.Done));
            Assert.That(Png.Read(Path.Combine(folder, "flight.png")).Rgba, Is.EqualTo(Png.Read(Path.Combine(folder, "last.png")).Rgba));
        }

        [TestCase("0 1 2 3 4 5\n", "line 1")]
        [TestCase("0 1 2 3 4 5 6\n0 1 2 3 4 5 6\n", "line 2")]
        [TestCase("0 1 2 3 4 5 nan\n", "line 1")]
        [TestCase("# nothing\n", "no line")]
        public void Fly_PathThatIsNone_SaysWhere(string text, string said)
        {
            string path = m_scratch["bad.txt"];
            File.WriteAllText(path, text);
            var call = CliCall.Of("fly", m_cloud, "--path", path);
            Assert.That(call.Status, Is.EqualTo(ExitStatus.BadInput));
            Assert.That(call.Error, Does.Contain(path).And.Contains(said));
        }

        [Test]
        public void Fly_NoCloud_SaysSo()
        {
            var call = CliCall.Of("fly", m_scratch["none.fastpoints"]);
            Assert.That(call.Status, Is.EqualTo(ExitStatus.Failed));
            Assert.That(call.Error, Does.Contain("none.fastpoints"));
        }

        [TestCase("--budget", "0")]
        [TestCase("--every", "0")]
        [TestCase("--every", "3601")]
        [TestCase("--pool", "0")]
        public void Fly_NumberOutOfRange_IsWrongUsage(string option, string value)
        {
            var call = CliCall.Of("fly", m_cloud, option, value);
            Assert.That(call.Status, Is.EqualTo(ExitStatus.Usage));
            Assert.That(call.Error, Does.Contain(option));
        }
    }
}
