using System.Collections.Generic;
using System.Linq;
using FastPoints.Drawing;
using FastPoints.Reading;
using FastPoints.Store;
using FastPoints.Streaming;
using FastPoints.Tests.Nodes;
using FastPoints.Tests.Streaming;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Tests.Drawing
{
    [Category("Smoke")]
    public sealed unsafe class DrawListTests
    {
        const double Ulp = 1.0 / (1 << 23);

        SizeTree m_sizes;

        [SetUp]
        public void MakeSizes() => m_sizes = new SizeTree();

        [TearDown]
        public void FreeSizes() => m_sizes.Dispose();

        static StreamContext Open(StreamedTestCloud cloud, double3x3 linear, double3 moved)
        {
            var stream = StreamedTestCloud.Stream();
            var source = cloud.Open();
            var geo = StreamedTestCloud.Geo(source);
            var origin = math.mul(linear, geo.OriginWorld - StreamedTestCloud.OriginGeo) + moved;
            stream.Add(source, new CloudPlacement(linear, origin));
            return stream;
        }

        DrawList List(StreamContext stream, StreamView view)
        {
            var list = new DrawList(m_sizes);
            list.SetLook(0, new CloudLook { Source = ColorSource.Channels, Plane = 1, Scale = 1 / 256.0 });
            list.Build(stream, view);
            return list;
        }

        [Test]
        public void Build_Progressive_FindsNodesInTheListBefore()
        {
            using var cloud = new StreamedTestCloud();
            using var stream = Open(cloud, double3x3.identity, 0);
            var view = StreamView.Everything(1000);
            Settle(stream, view);
            using var list = List(stream, view);
            Assert.That(list.PreviousFirstInstanceOfNode.Length, Is.Zero, "nobody asked");
            list.IsProgressive = true;
            list.Build(stream, view);
            Assert.That(list.PreviousFirstInstanceOfNode, Is.All.EqualTo(ListedSlot.None));
            var before = list.Nodes.ToArray();
            // One node has another tenant, the others are in another order.
            var drawn = stream.Drawn.AsArray();
            (drawn[0], drawn[drawn.Length - 1]) = (drawn[drawn.Length - 1], drawn[0]);
            var replaced = drawn[1];
            replaced.Version++;
            drawn[1] = replaced;
            list.Build(stream, view);
            for (int node = 0; node < list.Nodes.Length; node++)
            {
                var same = list.Nodes[node];
                uint last = before.Single(b => b.PositionWord == same.PositionWord && b.AnchorView.Equals(same.AnchorView))
                    .FirstInstance;
                Assert.That(list.PreviousFirstInstanceOfNode[node], Is.EqualTo(node == 1 ? ListedSlot.None : last));
            }
            Assert.That(list.Nodes.ToArray().Select(n => n.FirstInstance), Is.Not.EqualTo(before.Select(b => b.FirstInstance)));
        }

        static StreamView EverythingFrom(double3 eyeWorld)
        {
            var view = StreamView.Everything(1000);
            view.EyeWorld = eyeWorld;
            return view;
        }

        static void Settle(StreamContext stream, StreamView view)
        {
            using var views = new NativeArray<StreamView>(1, Allocator.Temp) { [0] = view };
            while (!FrameStep.Run(stream, views).IsSettled)
                System.Threading.Thread.Yield();
        }

        static IEnumerable<(double3 Drawn, double3 True)> PositionsOf(StreamContext stream, DrawList list, double3 eyeWorld)
        {
            var positions = new List<(double3, double3)>();
            foreach (var draw in list.Draws)
            {
                byte* bank = ((MemoryNodePool)stream.Pool).AddressOf(new PoolRange { Bank = draw.Bank });
                for (int i = draw.FirstInstance; i < draw.FirstInstance + draw.InstanceCount; i++)
                {
                    var node = list.Nodes[(int)list.NodeOfInstance[i]];
                    int block = i - (int)node.FirstInstance;
                    var shape = new PlaneShape(3, (node.Bits & 1) != 0 ? 7 : 0);
                    var plane = new PlaneView(bank + node.PositionWord * 4L, shape, block + 1);
                    for (int point = 0; point < plane.PointsOf(block); point++)
                        positions.Add(PositionOf(stream, list, eyeWorld, node, axis => (long)plane.ValueAt(block, axis, point)));
                }
            }
            return positions;
        }

        static (double3, double3) PositionOf(StreamContext stream, DrawList list, double3 eyeWorld, GpuNode node,
            System.Func<int, long> valueOf)
        {
            var cloud = stream.Clouds[0];
            var step = cloud.Source.Grid.Step;
            var record = list.Clouds[(int)node.Cloud];
            var steps = new float3();
            var offset = new double3();
            for (int axis = 0; axis < 3; axis++)
            {
                long anchor = (long)((ulong)node.AnchorHigh[axis] << 32 | node.Anchor[axis]);
                long value = valueOf(axis);
                steps[axis] = value >= anchor ? (float)(ulong)(value - anchor) : -(float)(ulong)(anchor - value);
                offset[axis] = value - anchor;
            }
            float3 drawn = node.AnchorView + record.StepX * steps.x + record.StepY * steps.y + record.StepZ * steps.z;
            // The corner is not in the record: from the anchor's own place, which a test below holds.
            var corner = CornerOf(stream, node);
            var anchorGrid = new double3((long)((ulong)node.AnchorHigh.x << 32 | node.Anchor.x),
                (long)((ulong)node.AnchorHigh.y << 32 | node.Anchor.y), (long)((ulong)node.AnchorHigh.z << 32 | node.Anchor.z));
            var local = (corner + anchorGrid + offset) * step;
            return (drawn, math.mul(cloud.Placement.Linear, local) + (cloud.Placement.OriginWorld - eyeWorld));
        }

        static double3 CornerOf(StreamContext stream, GpuNode node)
        {
            foreach (var drawn in stream.Drawn)
            {
                if ((uint)drawn.Range.FirstPage * (NodePool.PageBytes / 4) != node.PositionWord)
                    continue;
                var corner = stream.Clouds[0].Pages[drawn.Page].Addresses[drawn.Node].Corner;
                return new double3(corner.X, corner.Y, corner.Z);
            }
            throw new KeyNotFoundException();
        }

        static readonly object[] s_cameras =
        {
            new object[] { new double3(100.004, 100.003, 3), 1.0, 0.0 },
            new object[] { new double3(100, 100, 1e7), 1.0, 0.0 },
            new object[] { new double3(-30, 250, 4), 1e-3, 0.7 },
            new object[] { new double3(20, 30, 2), 1e6, 2.1 },
        };

        /// <summary>Also where the camera stands in the middle of all points, in metres times <paramref name="scale"/>.</summary>
        [TestCaseSource(nameof(s_cameras))]
        public void Build_AnyCamera_RoundsAMillionthOfTheDistance(double3 eye, double scale, double turned)
        {
            using var cloud = new StreamedTestCloud(30_000);
            var linear = Turned(turned, new double3(scale, scale * 0.5, scale * 2));
            var moved = new double3(4.6e6, -1.2e6, 33) * scale;
            using var stream = Open(cloud, linear, moved);
            var eyeWorld = math.mul(linear, eye) + moved;
            Settle(stream, EverythingFrom(eyeWorld));
            using var list = List(stream, EverythingFrom(eyeWorld));
            CheckPositions(stream, list, eyeWorld, 30_000, 0);
        }

        /// <summary>A root cube of more than 2^32 steps, whose points are 64-bit columns, and the camera a few steps from one
        /// of them.</summary>
        [Test]
        public void Build_WideCloud_RoundsAMillionthOfTheDistance()
        {
            var random = new Random(5);
            int3[] positions = Enumerable.Range(0, 3000).Select(_ => random.NextInt3(-2_000_000_000, 2_000_000_000)).ToArray();
            PointReader Reader(double moved) => MemoryReader.Of(positions, new PositionTransform
            {
                Scale = new double3(0.001, 0.001, 0.001),
                Offset = new double3(moved, 0, 0),
            });
            using var cloud = new StreamedTestCloud(1000, Reader(0), Reader(8e6), Reader(2e9));
            using var stream = Open(cloud, double3x3.identity, StreamedTestCloud.OriginGeo);
            var eye = new double3(8e6, 0, 0) + (double3)positions[17] * 0.001 + new double3(0.003, 0.002, -0.001);
            Settle(stream, EverythingFrom(eye));
            using var list = List(stream, EverythingFrom(eye));
            Assert.That(list.Nodes.ToArray().Any(n => (n.Bits & 1) != 0));
            CheckPositions(stream, list, eye, 9000, 4e9 / (1L << 52));
        }

        /// <param name="ulpWorld">What a double cannot tell apart that far from the origin.</param>
        static void CheckPositions(StreamContext stream, DrawList list, double3 eyeWorld, int points, double ulpWorld)
        {
            int count = 0;
            double worst = 0;
            foreach (var (drawn, wanted) in PositionsOf(stream, list, eyeWorld))
            {
                count++;
                worst = math.max(worst, (math.length(drawn - wanted) - ulpWorld) / math.length(wanted));
            }
            Assert.That(count, Is.EqualTo(points));
            Assert.That(worst, Is.GreaterThan(0).And.LessThan(4 * Ulp));
        }

        static double3x3 Turned(double angle, double3 scale)
        {
            double sin = math.sin(angle), cos = math.cos(angle);
            return new double3x3(scale * new double3(cos, sin, 0), scale * new double3(-sin, cos, 0),
                scale * new double3(0, 0, 1));
        }

        [Test]
        public void Build_CameraSeesAPart_ListsVisibleNodesAndEachBlockOnce()
        {
            using var cloud = new StreamedTestCloud(60_000, 4000);
            using var stream = Open(cloud, double3x3.identity, StreamedTestCloud.OriginGeo);
            StreamedTestCloud.Settle(stream, StreamedTestCloud.Overview());
            var camera = StreamedTestCloud.Near(20, 30, 0.6);
            using var list = List(stream, camera.ToStreamView(StreamedTestCloud.WidthPx, StreamedTestCloud.HeightPx));
            Assert.That(list.Nodes.Length, Is.GreaterThan(10).And.LessThan(stream.Drawn.Length));
            Assert.That(list.Draws.ToArray().Select(d => d.Bank), Is.Unique.And.Ordered);
            Assert.That(list.Draws.ToArray().Sum(d => d.InstanceCount), Is.EqualTo(list.NodeOfInstance.Length));
            long points = PositionsOf(stream, list, camera.EyeGeo).LongCount();
            Assert.That(points, Is.EqualTo(list.Points).And.LessThan(60_000));
            int instance = 0;
            foreach (uint node in list.NodeOfInstance)
                Assert.That(instance++, Is.GreaterThanOrEqualTo((int)list.Nodes[(int)node].FirstInstance));
        }

        [Test]
        public void Build_CloudWithoutALook_IsNotDrawn()
        {
            using var cloud = new StreamedTestCloud(5000);
            using var stream = Open(cloud, double3x3.identity, StreamedTestCloud.OriginGeo);
            using var list = new DrawList(m_sizes);
            StreamedTestCloud.Settle(stream, StreamedTestCloud.Overview());
            list.Build(stream, EverythingFrom(StreamedTestCloud.OriginGeo));
            Assert.That(list.Draws.Length, Is.Zero);
            Assert.That(list.Points, Is.Zero);
        }
    }
}
