using System;
using System.IO;
using System.Linq;
using FastPoints.Picture;
using FastPoints.Reading;
using FastPoints.Sampling;
using FastPoints.Sources;
using NUnit.Framework;

namespace FastPoints.Tests.Picture
{
    public class PreviewSegmentTests : FolderTests
    {
        const int Lines = 800_000, ShortLine = 20, LongLine = 160;

        string m_path;

        void Write(string name, string header)
        {
            m_path = Folder.File("cloud" + name);
            using var writer = new StreamWriter(m_path);
            writer.Write(header);
            for (int i = 0; i < Lines; i++)
            {
                string line = i + " " + i % 1000 + " 7";
                writer.Write(line.PadRight((i < Lines / 2 ? ShortLine : LongLine) - 1));
                writer.Write('\n');
            }
        }

        static double[] Xs(PreviewSample sample)
        {
            var column = sample.Points.Schema[0].Type == AttributeType.Int64
                ? sample.Points.Column<long>(AttributeNames.X).ToArray().Select(x => x * sample.Transform.Scale.x)
                : sample.Points.Column<float>(AttributeNames.X).ToArray().Select(x => (double)x);
            return column.Take(sample.Count).Select(x => Math.Round(x)).ToArray();
        }

        [TestCase(".xyz", "")]
        [TestCase(".ply", "ply\nformat ascii 1.0\nelement vertex 800000\nproperty float x\n"
            + "property float y\nproperty float z\nend_header\n")]
        public void QuickPreview_LongText_SamplesLinesOfAnyLengthEvenly(string name, string header)
        {
            Write(name, header);
            using var reader = PointReaders.Open(m_path);
            var prefixes = (IPrefixSource)reader;
            Assert.That(prefixes.HasPrefixes, Is.True);
            using var preview = new PreviewPicture(reader, new PreviewOptions { Points = 100_000, Quick = true });
            JobCoroutine.RunToEnd(preview.TakeSample(new StageProgress()));
            Assert.That(reader.BlocksAreKnown, Is.False, "that takes a look through all of the file");
            var sample = preview.Sample;
            var xs = Xs(sample);
            Assert.That(sample.IsOfPrefix, Is.False);
            Assert.That(xs.Distinct().Count(), Is.EqualTo(xs.Length));
            // Eight ninths of the bytes are the second half's. A segment has 820 or 103 lines to choose from: one more or less
            // at its ends moves the shares by less than a hundredth.
            Assert.That(xs.Count(x => x < Lines / 2) / (double)xs.Length, Is.EqualTo(0.5).Within(0.02));
            foreach (var eighth in xs.GroupBy(x => (int)x / (Lines / 8)))
                Assert.That(eighth.Count() / (double)xs.Length, Is.EqualTo(0.125).Within(0.01));
            var estimate = prefixes.EstimatedPoints;
            Assert.That(estimate.Points, Is.EqualTo(Lines).Within(Math.Max(1, 4 * estimate.StandardError)));
            Assert.That(estimate.StandardError, Is.LessThan(0.01 * Lines));
            Assert.That(sample.Fraction, Is.EqualTo(xs.Length / estimate.Points).Within(1e-6));
            Assert.That(reader.Info.Warnings, Has.Count.EqualTo(name == ".ply" ? 0 : 1));
        }

        [Test]
        public void Preview_LongText_EndsWithTheFullScansPoints()
        {
            Write(".xyz", "");
            using var exactReader = PointReaders.Open(m_path);
            using var exact = new PreviewPicture(exactReader, new PreviewOptions { Points = 20_000, Exact = true });
            JobCoroutine.RunToEnd(exact.TakeSample(new StageProgress()));
            using var reader = PointReaders.Open(m_path);
            using var preview = new PreviewPicture(reader, new PreviewOptions { Points = 20_000 });
            int widest = 0;
            preview.WaveReady += (sample, wave) =>
                widest = Math.Max(widest, Xs(sample).GroupBy(x => (int)x / (Lines / 8)).Count());
            JobCoroutine.RunToEnd(preview.TakeSample(new StageProgress()));
            Assert.That(Xs(preview.Sample), Is.EqualTo(Xs(exact.Sample)));
            Assert.That(preview.Waves.Count, Is.EqualTo(5));
            Assert.That(widest, Is.EqualTo(8));
            Assert.That(reader.Info.Warnings, Is.Empty);
        }

        [Test]
        public void HasPrefixes_PlyWithFaces_IsFalse()
        {
            Write(".ply", "ply\nformat ascii 1.0\nelement vertex 799999\nproperty float x\nproperty float y\nproperty float z\n"
                + "element face 1\nproperty list uchar int vertex_indices\nend_header\n");
            using var reader = PointReaders.Open(m_path);
            Assert.That(((IPrefixSource)reader).HasPrefixes, Is.False);
        }
    }
}
