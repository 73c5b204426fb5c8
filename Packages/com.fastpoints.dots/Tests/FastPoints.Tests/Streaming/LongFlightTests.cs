using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using FastPoints.Drawing;
using FastPoints.Evaluation;
using FastPoints.Picture;
using FastPoints.Streaming;
using NUnit.Framework;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Tests.Streaming
{
    /// <summary>Thousands of frames in which everything happens at once: teleports, budgets and limits that change, clouds that
    /// come and go, files that vanish and come back. Nothing leaks, no limit is passed, nothing fails but what was made to, and
    /// in the end the picture is that of a fresh load.</summary>
    public class LongFlightTests
    {
        static readonly double3 s_beside = new double3(0, 210, 0);

        StreamedTestCloud m_cloud;

        [SetUp]
        public void MakeCloud() => m_cloud = new StreamedTestCloud(60_000, 4000);

        [TearDown]
        public void DeleteCloud() => m_cloud.Dispose();

        [TestCase(1500, 1u), TestCase(10_000, 2u), TestCase(10_000, 3u)]
        [Category("Long"), Explicit]
        public void Fly_RandomEvents_EndsLikeAFreshLoad(int frames, uint seed)
        {
            UnsafeUtility.ForgiveLeaks();
            var last = StreamedTestCloud.Near(60, 80, 0.7);
            byte[] flown, fresh;
            using (var stream = StreamedTestCloud.Stream(1 << 20, 128 << 10))
            {
                Fly(stream, frames, seed);
                for (int c = 0; c < stream.Clouds.Count; c++)
                    stream.Remove(c);
                StreamedTestCloud.Settle(stream, last);
                Assert.That(stream.Pool.UsedBytes, Is.Zero);
                Assert.That(stream.Cache.Count, Is.Zero);
                // What was reported as broken stays so for the cloud that it was reported of: the next one starts over.
                flown = Picture(stream, last);
                Assert.That(stream.Pool.FindProblem(), Is.Null);
            }
            using (var stream = StreamedTestCloud.Stream())
                fresh = Picture(stream, last);
            Assert.That(flown.SequenceEqual(fresh), Is.True);
            Assert.That(UnsafeUtility.CheckForLeaks(), Is.Zero);
        }

        void Fly(StreamContext stream, int frames, uint seed)
        {
            var random = new Unity.Mathematics.Random(seed);
            var gone = new List<string>();
            string[] files = m_cloud.ChunkFiles.OrderBy(f => f, StringComparer.Ordinal).ToArray();
            bool hasLost = false;
            var camera = StreamedTestCloud.Overview();
            var step = new double3(0, 0, 0);
            m_cloud.Add(stream, 0);
            for (int frame = 0; frame < frames; frame++)
            {
                switch (random.NextInt(120))
                {
                    case 0:
                    case 1:
                    case 2:
                        camera = StreamedTestCloud.Near(random.NextFloat(200), random.NextFloat(200), random.NextFloat(6));
                        step = random.NextDouble3(-1, 1);
                        break;
                    case 3:
                        camera = StreamedTestCloud.Overview();
                        break;
                    case 4:
                        stream.Settings.Selection.PointBudget = 1000 + random.NextInt(100_000);
                        break;
                    case 5:
                        stream.Pool.LimitBytes = (long)random.NextInt(12) * stream.Pool.BankBytes;
                        break;
                    case 6:
                        if (stream.Clouds.Count(c => c != null && !c.IsRemoving) < 3)
                            m_cloud.Add(stream, random.NextBool() ? 0 : s_beside);
                        break;
                    case 7:
                        stream.Remove(random.NextInt(stream.Clouds.Count));
                        break;
                    case 8:
                        // Folders list their files in any order.
                        string file = files[random.NextInt(files.Length)];
                        if (gone.Count < 3 && !gone.Contains(file))
                        {
                            File.Move(file, file + ".gone");
                            gone.Add(file);
                            hasLost = true;
                        }
                        break;
                    case 9:
                        foreach (string lost in gone)
                            File.Move(lost + ".gone", lost);
                        gone.Clear();
                        break;
                    case 10:
                        stream.Settings.MaxReads = 1 + random.NextInt(30);
                        stream.Settings.MaxBytesPerRead = 1 + random.NextInt(1 << 18);
                        stream.Settings.MaxUploadBytesPerFrame = 1 + random.NextInt(1 << 18);
                        break;
                }
                camera.EyeGeo += step;
                var stats = StreamedTestCloud.Frame(stream, camera);
                long still = stream.Uploads.IsInFlight ? stream.Pool.AllocatedBytes : stream.Pool.LimitBytes;
                Assert.That(stats.PoolBytes, Is.LessThanOrEqualTo(Math.Max(still, stream.Pool.LimitBytes)));
                Assert.That(stats.SelectedPoints, Is.LessThanOrEqualTo(Math.Max(1000, stream.Settings.Selection.PointBudget)));
                Assert.That(stats.DrawnPoints, Is.LessThanOrEqualTo(stats.SelectedPoints));
                if (frame % 100 == 0)
                    Assert.That(stream.Pool.FindProblem(), Is.Null);
                while (stream.TryTakeFailure(out var failure))
                {
                    Assert.That(hasLost, Is.True, failure.ToString());
                    Assert.That(failure.What, Does.Contain("cannot be read"));
                }
            }
            foreach (string lost in gone)
                File.Move(lost + ".gone", lost);
            stream.Pool.LimitBytes = 64 << 20;
            stream.Settings.Selection = StreamedTestCloud.Selection;
        }

        byte[] Picture(StreamContext stream, Camera camera)
        {
            var options = new PictureOptions { WidthPx = StreamedTestCloud.WidthPx, HeightPx = StreamedTestCloud.HeightPx };
            var ranges = new DisplayRanges { Color = ColorDepth.Bits16 };
            using var picture = new StreamedPicture(options);
            foreach (var moved in new[] { new double3(0, 0, 0), s_beside })
            {
                int cloud = m_cloud.Add(stream, moved);
                var source = stream.Clouds[cloud].Source;
                var plan = new PicturePlan(options, ranges, source.Grid.TransformFromCorner(source.Root.Corner));
                picture.Add(new StreamedBlocks(stream, cloud, plan), ColorMode.Rgb);
            }
            StreamedTestCloud.Settle(stream, camera);
            var image = picture.Draw(camera);
            Assert.That(image.Rgba.Distinct().Count(), Is.GreaterThan(20), "the picture is empty");
            return image.Rgba;
        }
    }
}
