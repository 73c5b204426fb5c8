using System;
using System.IO;
using FastPoints.Build;
using FastPoints.Drawing;
using FastPoints.Picture;
using FastPoints.Store;
using FastPoints.Streaming;
using NUnit.Framework;

namespace FastPoints.Tests.Streaming
{
    public class StreamNormalsTests
    {
        static readonly string[] s_planes = { StoreLayout.ColorName, StoreLayout.NormalName };

        StreamedTestCloud m_cloud;

        [SetUp]
        public void MakeCloud()
        {
            m_cloud = new StreamedTestCloud(40_000);
            JobCoroutine.RunToEnd(AddNormals.Run(m_cloud.Path, new NormalSettings(), null, null));
        }

        [TearDown]
        public void DeleteCloud() => m_cloud.Dispose();

        [Test]
        public unsafe void Run_CloudWithNormals_LoadsThemFromTheirFile()
        {
            using var stream = StreamedTestCloud.Stream();
            var source = m_cloud.Open(s_planes);
            stream.Add(source, StreamedTestCloud.Geo(source));
            StreamedTestCloud.Settle(stream, StreamedTestCloud.Overview());
            Assert.That(stream.TryTakeFailure(out var failure), Is.False, failure.ToString());
            Assert.That(source.Planes.Length, Is.EqualTo(3));
            Assert.That(stream.Drawn.Length, Is.GreaterThan(10));
            var cloud = stream.Clouds[0];
            foreach (var drawn in stream.Drawn.AsArray())
            {
                byte* at = ((MemoryNodePool)stream.Pool).AddressOf(drawn.Range);
                for (int plane = 0; plane < 3; plane++)
                {
                    string path = plane == 2 ? source.PathOfComputed(drawn.Page) : source.PlanesPathOf(drawn.Page);
                    var range = cloud.RangeOf(drawn.Page, drawn.Node, plane);
                    var stored = File.ReadAllBytes(path).AsSpan((int)range.OffsetBytes, (int)range.LengthBytes);
                    Assert.That(new Span<byte>(at, stored.Length).SequenceEqual(stored), path);
                    at += range.LengthBytes;
                }
            }
        }

        [Test]
        public void Run_DamagedNormals_AreReportedWithTheirFile()
        {
            using var folder = CloudFolder.Open(m_cloud.Path);
            string path = folder.PathOfComputed(0);
            var range = folder.Root.PlaneRanges[folder.Root.PlaneCount - 1];
            byte[] bytes = File.ReadAllBytes(path);
            bytes[range.OffsetBytes + range.LengthBytes / 2] ^= 1;
            File.WriteAllBytes(path, bytes);
            using var stream = StreamedTestCloud.Stream();
            var source = m_cloud.Open(s_planes);
            stream.Add(source, StreamedTestCloud.Geo(source));
            StreamedTestCloud.Settle(stream, StreamedTestCloud.Overview());
            Assert.That(stream.TryTakeFailure(out var failure), Is.True);
            Assert.That(failure.ToString(), Is.EqualTo(path + " at " + range.OffsetBytes + ": node 0 is damaged"));
            Assert.That(stream.TryTakeFailure(out _), Is.False);
        }

        [Test]
        public void Picture_CloudWithNormals_IsLitByThem()
        {
            using var plain = new StreamedTestCloud(40_000);
            foreach (bool isLit in new[] { false, true })
            {
                byte[] Draw(string cloud)
                {
                    var options = new PictureOptions { WidthPx = 160, HeightPx = 90, Color = ColorMode.Elevation };
                    (options.LitFraction, options.EdlStrength, options.PointSizePx) = (isLit ? 1 : 0, 0, 3);
                    using var folder = CloudFolder.Open(cloud);
                    var draw = new DrawConvertedCloud(folder, options);
                    JobCoroutine.RunToEnd(draw.Run(null));
                    return draw.Image.Rgba;
                }
                Assert.That(Draw(m_cloud.Path), isLit ? Is.Not.EqualTo(Draw(plain.Path)) : Is.EqualTo(Draw(plain.Path)));
            }
        }

        [Test]
        public void Run_FileOfNormalsIsGone_IsReportedWithItsName()
        {
            string path;
            using (var folder = CloudFolder.Open(m_cloud.Path))
                path = folder.PathOfComputed(0);
            File.Delete(path);
            using var stream = StreamedTestCloud.Stream();
            var source = m_cloud.Open(s_planes);
            stream.Add(source, StreamedTestCloud.Geo(source));
            StreamedTestCloud.Settle(stream, StreamedTestCloud.Overview());
            Assert.That(stream.TryTakeFailure(out var failure), Is.True);
            Assert.That(failure.Path, Is.EqualTo(path));
        }
    }
}
