using System.Collections.Generic;
using FastPoints.Drawing;
using FastPoints.Evaluation;
using FastPoints.Streaming;
using FastPoints.Tests.Nodes;
using FastPoints.Tests.Streaming;
using NUnit.Framework;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Tests.Drawing
{
    public sealed unsafe class SizeTreeTests
    {
        StreamedTestCloud m_cloud;

        [OneTimeSetUp]
        public void MakeCloud() => m_cloud = new StreamedTestCloud();

        [OneTimeTearDown]
        public void DeleteCloud() => m_cloud?.Dispose();

        static (Grid3 Corner, long Edge) CubeOf(StreamContext stream, DrawnNode drawn)
        {
            var cloud = stream.Clouds[drawn.Cloud];
            var address = cloud.Pages[drawn.Page].Addresses[drawn.Node];
            return (address.Corner, cloud.Source.Root.Side >> address.Level);
        }

        static bool Contains((Grid3 Corner, long Edge) cube, Grid3 position)
        {
            var from = position - cube.Corner;
            return from.X >= 0 && from.Y >= 0 && from.Z >= 0 && from.X < cube.Edge && from.Y < cube.Edge && from.Z < cube.Edge;
        }

        static int DeepestBelow(StreamContext stream, Dictionary<int, List<int>> childrenOf, int drawn, Grid3 position)
        {
            for (; ; )
            {
                int next = -1;
                long edge = CubeOf(stream, stream.Drawn[drawn]).Edge;
                if (childrenOf.TryGetValue(drawn, out var children))
                    foreach (int child in children)
                    {
                        var cube = CubeOf(stream, stream.Drawn[child]);
                        if (cube.Edge < edge && Contains(cube, position))
                            next = child;
                    }
                if (next < 0)
                    return drawn;
                drawn = next;
            }
        }

        [TestCase(5_000, 1.0), TestCase(30_000, 1.0), TestCase(1_000_000, 3.5)]
        public void GapAt_AnyPositionInAnyNode_IsThatOfTheDeepestDrawnNode(int budget, double scale)
        {
            using var stream = StreamedTestCloud.Stream();
            using var sizes = new SizeTree();
            var source = m_cloud.Open();
            var placement = StreamedTestCloud.Geo(source);
            placement.Linear = new double3x3(new double3(1, 0, 0), new double3(0, scale, 0), new double3(0, 0, 1));
            stream.Add(source, placement);
            stream.Settings.Selection.PointBudget = budget;
            StreamedTestCloud.Settle(stream, StreamedTestCloud.Near(60, 60, 0.6));
            sizes.Build(stream);
            CheckGaps(stream, sizes, (float)scale);
        }

        [Test]
        public void GapAt_NodesLevelsBelowTheirParents_IsThatOfTheDeepestDrawnNode()
        {
            var random = new Random(3);
            var positions = new int3[60_000];
            for (int i = 0; i < positions.Length; i++)
                positions[i] = new int3(i % 3 * 900_000, i % 2 * 900_000, 0) + random.NextInt3(2000);
            var centimetres =
                new PositionTransform { Scale = new double3(0.01, 0.01, 0.01), Offset = StreamedTestCloud.OriginGeo };
            using var cloud = new StreamedTestCloud(6000, MemoryReader.Of(positions, centimetres, 5000));
            using var stream = StreamedTestCloud.Stream();
            using var sizes = new SizeTree();
            var source = cloud.Open();
            stream.Add(source, StreamedTestCloud.Geo(source));
            stream.Settings.Selection.MinScreenErrorPx = 0;
            stream.Settings.Selection.MinNodePx = 0;
            var center = StreamedTestCloud.OriginGeo + new double3(9000, 4500, 0);
            StreamedTestCloud.Settle(stream,
                FastPoints.Picture.Camera.Perspective(center + new double3(0, -30_000, 20_000), center,
                new double3(0, 0, 1), 60));
            sizes.Build(stream);
            int far = 0;
            foreach (var drawn in stream.Drawn)
            {
                bool isFar = drawn.Parent >= 0 &&
                    CubeOf(stream, drawn).Edge * 2 < CubeOf(stream, stream.Drawn[drawn.Parent]).Edge;
                far += isFar ? 1 : 0;
            }
            Assert.That(far, Is.GreaterThan(2));
            Assert.That(sizes.Nodes.Length, Is.GreaterThan(stream.Drawn.Length));
            CheckGaps(stream, sizes, 1);
        }

        static void CheckGaps(StreamContext stream, SizeTree sizes, float scale)
        {
            Assert.That(sizes.Nodes.Length, Is.GreaterThanOrEqualTo(stream.Drawn.Length));
            Assert.That(stream.Drawn.Length, Is.GreaterThan(2));
            var childrenOf = new Dictionary<int, List<int>>();
            for (int i = 0; i < stream.Drawn.Length; i++)
            {
                int parent = stream.Drawn[i].Parent;
                Assert.That(parent, Is.LessThan(i));
                if (parent >= 0 && !childrenOf.ContainsKey(parent))
                    childrenOf.Add(parent, new List<int>());
                if (parent >= 0)
                    childrenOf[parent].Add(i);
            }
            var random = new Random(5);
            int deeper = 0;
            for (int i = 0; i < stream.Drawn.Length; i++)
            {
                var drawn = stream.Drawn[i];
                var cube = CubeOf(stream, drawn);
                for (int trial = 0; trial < 50; trial++)
                {
                    var inCube = random.NextDouble3();
                    var steps = math.floor(inCube * cube.Edge);
                    var position = cube.Corner + new Grid3((long)steps.x, (long)steps.y, (long)steps.z);
                    int wanted = DeepestBelow(stream, childrenOf, i, position);
                    float gap = DrawBlocksJob.GapAt((GpuSizeNode*)sizes.Nodes.GetUnsafeReadOnlyPtr(), sizes.NodeOfDrawn[i],
                        (float3)((steps + 0.5) / cube.Edge));
                    Assert.That(gap, Is.EqualTo(sizes.Nodes[sizes.NodeOfDrawn[wanted]].Gap), "node " + i + " at " + inCube);
                    deeper += wanted != i ? 1 : 0;
                }
                var page = stream.Clouds[drawn.Cloud].Pages + drawn.Page;
                float max = page->Nodes[drawn.Node].Spacing * scale;
                bool isLast = page->Nodes[drawn.Node].ChildCount + page->Nodes[drawn.Node].PageCount == 0;
                float own = sizes.Nodes[sizes.NodeOfDrawn[i]].Gap;
                Assert.That(own, isLast ? (NUnit.Framework.Constraints.IResolveConstraint)Is.InRange(0, max) : Is.EqualTo(max));
            }
            Assert.That(deeper, Is.GreaterThan(stream.Drawn.Length));
        }

        /// <summary>A surface of the test's cloud has 3 points a square unit: the last nodes know that, whatever their
        /// spacing is.</summary>
        [Test]
        public void Gap_LeavesOfASurface_IsAboutThePointSpacing()
        {
            using var stream = StreamedTestCloud.Stream();
            using var sizes = new SizeTree();
            var source = m_cloud.Open();
            stream.Add(source, StreamedTestCloud.Geo(source));
            stream.Settings.Selection.PointBudget = 1_000_000;
            stream.Settings.Selection.MinScreenErrorPx = 0;
            stream.Settings.Selection.MinNodePx = 0;
            StreamedTestCloud.Settle(stream, StreamedTestCloud.Overview());
            sizes.Build(stream);
            double between = 1 / math.sqrt(120_000 / (200.0 * 200.0));
            var gaps = new List<float>();
            for (int i = 0; i < stream.Drawn.Length; i++)
            {
                var drawn = stream.Drawn[i];
                var node = stream.Clouds[0].Pages[drawn.Page].Nodes[drawn.Node];
                if (node.ChildCount + node.PageCount == 0 && node.PointCount > 100)
                    gaps.Add(sizes.Nodes[sizes.NodeOfDrawn[i]].Gap);
            }
            gaps.Sort();
            Assert.That(gaps.Count, Is.GreaterThan(50));
            Assert.That(gaps[gaps.Count / 2], Is.InRange(0.8 * between, 1.5 * between));
        }

        [Test]
        public void Build_CloudRemoved_HasNoneOfItsNodes()
        {
            using var stream = StreamedTestCloud.Stream();
            using var sizes = new SizeTree();
            var source = m_cloud.Open();
            int cloud = stream.Add(source, StreamedTestCloud.Geo(source));
            StreamedTestCloud.Settle(stream, StreamedTestCloud.Overview());
            stream.Remove(cloud);
            StreamedTestCloud.Settle(stream, StreamedTestCloud.Overview());
            sizes.Build(stream);
            Assert.That(sizes.Nodes.Length, Is.Zero);
        }
    }
}
