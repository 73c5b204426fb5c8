using System.Collections.Generic;
using FastPoints.Streaming;
using NUnit.Framework;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Tests.Streaming
{
    public sealed unsafe class ClipBoxTests
    {
        static ClipBox Turned(double3 center, double3 edges, double angle, bool cuts)
        {
            double sin = math.sin(angle), cos = math.cos(angle);
            return new ClipBox
            {
                CenterWorld = center,
                EdgesWorld = new double3x3(new double3(cos, sin, 0) * edges.x, new double3(-sin, cos, 0) * edges.y,
                    new double3(0, 0, edges.z)),
                Cuts = cuts,
            };
        }

        static bool IsIn(ClipBox box, double3 world)
        {
            var from = world - box.CenterWorld;
            for (int axis = 0; axis < 3; axis++)
            {
                var edge = box.EdgesWorld[axis];
                // Edges at right angles to one another.
                if (math.abs(math.dot(from, edge)) > math.dot(edge, edge) / 2)
                    return false;
            }
            return true;
        }

        [TestCase(0), TestCase(3)]
        public void Keeps_Positions_InKeepBoxesAndOutsideCutBoxes(int keeping)
        {
            var random = new Random(11);
            var placement = new CloudPlacement(new double3x3(new double3(0, 2, 0), new double3(-3, 0, 0), new double3(0, 0, 0.5)),
                new double3(691_000, 5_334_000, 520));
            var boxes = new List<ClipBox>();
            for (int i = 0; i < keeping + 2; i++)
                boxes.Add(Turned(placement.OriginWorld + random.NextDouble3(-20, 20),
                    random.NextDouble3(10, 40), random.NextDouble(3), i >= keeping));
            using var clips = new NativeList<LocalClip>(Allocator.Temp);
            var list = clips;
            foreach (var box in boxes)
                list.Add(new LocalClip(box, placement));
            int left = 0;
            for (int trial = 0; trial < 5000; trial++)
            {
                var local = random.NextDouble3(-12, 12);
                var world = math.mul(placement.Linear, local) + placement.OriginWorld;
                bool isKept = keeping == 0, isCut = false;
                foreach (var box in boxes)
                {
                    isKept |= !box.Cuts && IsIn(box, world);
                    isCut |= box.Cuts && IsIn(box, world);
                }
                bool isLeft = LocalClip.MayKeep(clips.GetUnsafePtr(), clips.Length, local, 0);
                Assert.That(isLeft, Is.EqualTo(isKept && !isCut), "at " + local);
                left += isLeft ? 1 : 0;

                // A box that has a place which is left is left.
                var half = random.NextDouble3(3);
                if (isLeft)
                    Assert.That(LocalClip.MayKeep(clips.GetUnsafePtr(), clips.Length,
                        local + half * random.NextDouble3(-1, 1), half),
                        Is.True, "around " + local);
            }
            Assert.That(left, Is.InRange(200, 4800));
        }

        [Test]
        public void Keeps_BoxWithoutVolume_ContainsNothing()
        {
            var flat = new ClipBox(new double3(0, 0, 0), new double3(1, 1, 0));
            var identity = new CloudPlacement(double3x3.identity, 0);
            var clip = new LocalClip(flat, identity);
            Assert.That(LocalClip.MayKeep(&clip, 1, new double3(0.5, 0.5, 0), 0), Is.False);
            flat.Cuts = true;
            clip = new LocalClip(flat, identity);
            Assert.That(LocalClip.MayKeep(&clip, 1, new double3(0.5, 0.5, 0), 0), Is.True);
        }

        [Test]
        public void Run_Clipped_StreamsOnlyInsideUntilUnclipped()
        {
            using var cloud = new StreamedTestCloud();
            using var stream = StreamedTestCloud.Stream();
            var source = cloud.Open();
            stream.Add(source, StreamedTestCloud.Geo(source));
            stream.Settings.Selection.MinScreenErrorPx = 0;
            long all = StreamedTestCloud.Settle(stream, StreamedTestCloud.Overview()).DrawnPoints;
            var box = new ClipBox(StreamedTestCloud.OriginGeo + new double3(40, 40, -50),
                StreamedTestCloud.OriginGeo + new double3(90, 90, 50));
            stream.ClipBoxes.Add(box);
            long inBox = StreamedTestCloud.Settle(stream, StreamedTestCloud.Overview()).DrawnPoints;
            Assert.That(inBox, Is.InRange(all / 32, all / 3), "of " + all);
            foreach (var drawn in stream.Drawn)
            {
                var node = stream.Clouds[0].Pages[drawn.Page].Nodes[drawn.Node];
                var low = node.Center - node.Half + stream.Clouds[0].Placement.OriginWorld;
                var high = node.Center + node.Half + stream.Clouds[0].Placement.OriginWorld;
                var min = box.CenterWorld - 25;
                var max = box.CenterWorld + 25;
                Assert.That(math.all(high.xy >= min.xy) && math.all(low.xy <= max.xy), Is.True);
            }
            box.Cuts = true;
            stream.ClipBoxes.Clear();
            stream.ClipBoxes.Add(box);
            long outside = StreamedTestCloud.Settle(stream, StreamedTestCloud.Overview()).DrawnPoints;
            Assert.That(outside, Is.LessThan(all).And.GreaterThan(all / 2));
            stream.ClipBoxes.Clear();
            Assert.That(StreamedTestCloud.Settle(stream, StreamedTestCloud.Overview()).DrawnPoints, Is.EqualTo(all));
        }
    }
}
