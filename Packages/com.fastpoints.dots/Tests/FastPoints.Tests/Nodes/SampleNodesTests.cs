using System;
using System.Collections.Generic;
using System.Linq;
using FastPoints.Nodes;
using FastPoints.Store;
using NUnit.Framework;

namespace FastPoints.Tests.Nodes
{
    [Category("Smoke")]
    public class SampleNodesTests
    {
        static readonly NodeSizes s_small = new NodeSizes { CellsLog2 = 4, TargetPointsPerLeaf = 100, MaxPointsPerNode = 300 };

        [TestCaseSource(typeof(SamplingClouds), nameof(SamplingClouds.All))]
        public void Sample_SmallCloud_IsExactlyTheReference(Grid3[] positions)
        {
            foreach (var sampler in new[] { Sampler.Random, Sampler.Poisson })
            {
                var sampled = SampledPoints.Run(positions, sampler, s_small);
                var reference = new SamplingReference(sampled.Positions, sampled.Priority, s_small, sampler);
                for (int i = 0; i < sampled.Positions.Length; i++)
                    Assert.That(sampled.IsSampled(i) ? sampled.Nodes[sampled.NodeOfPoint[i]].CellLog2 : -2,
                        Is.EqualTo(reference.CellOfPoint[i]), sampler + ", point " + i);
                CheckNodes(sampled, s_small);
            }
        }

        [TestCaseSource(typeof(SamplingClouds), nameof(SamplingClouds.All))]
        public void Sample_InSlices_IsTheSame(Grid3[] positions)
        {
            foreach (var sampler in new[] { Sampler.Random, Sampler.Poisson })
            {
                var whole = SampledPoints.Run(positions, sampler, s_small);
                var sliced = SampledPoints.Run(positions, sampler, s_small, 200);
                Assert.That(sliced.NodeOfPoint, Is.EqualTo(whole.NodeOfPoint));
                Assert.That(sliced.Nodes, Is.EqualTo(whole.Nodes));
            }
        }

        // 16 cells along an edge: of 280 places in a volume a node would take all but a few, of so many on two lines 64 at most.
        [TestCase(Sampler.Random)]
        [TestCase(Sampler.Poisson)]
        public void Sample_CubeAlmostExhaustedByANode_IsALeaf(Sampler sampler)
        {
            var scattered = SampledPoints.Run(SamplingClouds.Volume(280, 1 << 20), sampler, s_small);
            Assert.That(scattered.Nodes, Has.Length.EqualTo(1));
            Assert.That(scattered.Nodes[0].IsLeaf, Is.True);
            var lines =
                SampledPoints.Run(SamplingClouds.Make(280, (r, i) => (new Grid3(r.NextInt(1 << 20), 0, i % 2 << 19), r)), sampler,
                s_small);
            Assert.That(lines.Nodes.Length, Is.GreaterThan(1));
            Assert.That(lines.Nodes[0].IsLeaf, Is.False);
            var more = SampledPoints.Run(SamplingClouds.Volume(301, 1 << 20), sampler, s_small);
            Assert.That(more.Nodes.Length, Is.GreaterThan(1));
        }

        /// <summary>A scanner's dead pixels: the time must not grow with the square of their number.</summary>
        [Test]
        public void Sample_ManyEqualPoints_TakesBoundedTime([Values(Sampler.Random, Sampler.Poisson)] Sampler sampler)
        {
            var positions = SamplingClouds.Make(400000, (r, i) => (i % 3 == 0
                ? new Grid3(r.NextInt(1 << 20), r.NextInt(1 << 20), r.NextInt(1 << 12))
                : new Grid3(77777, 88888, 99), r));
            var watch = System.Diagnostics.Stopwatch.StartNew();
            var sampled = SampledPoints.Run(positions, sampler, NodeSizes.Default, SampleNodesJob.CostOfSlice);
            Assert.That(watch.Elapsed.TotalSeconds, Is.LessThan(30));
            CheckNodes(sampled, NodeSizes.Default);
            Assert.That(sampled.Nodes.Where(n => n.SideLog2 == 0).Sum(n => n.OwnCount), Is.EqualTo(266666).Within(30));
        }

        [Test]
        public void Sample_SurfaceAlongAFace_KeepsItsPoints([Values(0, 1 << 19)] int z)
        {
            var positions = SamplingClouds.Make(20000,
                (r, i) => (new Grid3(r.NextInt(1 << 20), r.NextInt(1 << 20), i < 9 ? i << 17 : z), r));
            Assert.That(SampledPoints.Run(positions, Sampler.Poisson, s_small).Nodes[0].OwnCount, Is.InRange(37, 48));
        }

        [TestCase(40), TestCase(61)]
        public void Sample_VastSpan_KeepsTheDistance(int bits)
        {
            var positions = SamplingClouds.Make(5000,
                (r, i) => (new Grid3(Long(ref r, bits), Long(ref r, i % 2 == 0 ? bits : 12), i % 3 == 0
                ? Long(ref r, bits)
                : 0), r));
            var sampled = SampledPoints.Run(positions, Sampler.Poisson, s_small);
            CheckNodes(sampled, s_small);
            Assert.That(sampled.SmallestRatio(), Is.InRange(0.99, 1.5));
        }

        static long Long(ref Unity.Mathematics.Random random, int bits) =>
            (long)(((ulong)random.NextUInt() << 32 | random.NextUInt()) >> (64 - bits));

        [Test]
        public void Sample_DenserThanANodeAllows_StopsAtItsLimit()
        {
            // The cap is less than what would fit at the coarsest cells that it allows: neighbours at exactly the spacing.
            var sizes = new NodeSizes { CellsLog2 = 4, TargetPointsPerLeaf = 10, MaxPointsPerNode = 64 };
            var sampled = SampledPoints.Run(SamplingClouds.Lattice(16, 16), Sampler.Poisson, sizes);
            CheckNodes(sampled, sizes);
        }

        [Test]
        public void Sample_ManyLevels_KeepsTheDistanceAcrossNodes()
        {
            foreach (var positions in new[] { SamplingClouds.Volume(30000, 1 << 20), SamplingClouds.Surface(30000, 1 << 18) })
            {
                var sizes =
                    new NodeSizes { CellsLog2 = 5, TargetPointsPerLeaf = 500, MaxPointsPerNode = StoreFormat.MaxPointsPerNode };
                var sampled = SampledPoints.Run(positions, Sampler.Poisson, sizes);
                CheckNodes(sampled, sizes);
                Assert.That(sampled.SmallestRatio(), Is.InRange(1.0, 1.01));
            }
        }

        [Test]
        public void Sample_Spacing_MatchesRandomDartThrowing()
        {
            var sizes =
                new NodeSizes { CellsLog2 = 5, TargetPointsPerLeaf = 100, MaxPointsPerNode = StoreFormat.MaxPointsPerNode };
            foreach (var positions in new[] { SamplingClouds.Volume(6000, 1 << 20), SamplingClouds.Surface(6000, 1 << 18) })
            {
                var sampled = SampledPoints.Run(positions, Sampler.Poisson, sizes);
                // All that is drawn of the two widest spacings, as a picture from afar would have it.
                int widest = 0;
                foreach (var node in sampled.Nodes)
                    widest = Math.Max(widest, node.CellLog2);
                var thrown = Thrown(sampled, widest);
                double own = Unevenness(sampled,
                    i => sampled.IsSampled(i) && sampled.Nodes[sampled.NodeOfPoint[i]].CellLog2 >= widest - 1);
                double wanted = Unevenness(sampled, i => thrown[i]);
                TestContext.WriteLine(own + " against " + wanted);
                Assert.That(own, Is.LessThanOrEqualTo(1.1 * wanted));
            }
        }

        static bool[] Thrown(SampledPoints sampled, int widest)
        {
            var order = new int[sampled.Positions.Length];
            for (int i = 0; i < order.Length; i++)
                order[i] = i;
            Array.Sort((uint[])sampled.Priority.Clone(), order);
            Array.Reverse(order);
            var thrown = new bool[order.Length];
            var taken = new List<int>();
            for (int cell = widest; cell >= widest - 1; cell--)
            {
                foreach (int point in order)
                {
                    if (thrown[point] || taken.Any(t => sampled.DistanceOf(t, point) < Math.Pow(2, cell)))
                        continue;
                    thrown[point] = true;
                    taken.Add(point);
                }
            }
            return thrown;
        }

        static double Unevenness(SampledPoints sampled, Func<int, bool> isChosen)
        {
            var chosen = new List<int>();
            for (int i = 0; i < sampled.Positions.Length; i++)
                if (isChosen(i))
                    chosen.Add(i);
            double sum = 0, squares = 0;
            foreach (int a in chosen)
            {
                double nearest = double.PositiveInfinity;
                foreach (int b in chosen)
                    if (a != b)
                        nearest = Math.Min(nearest, sampled.DistanceOf(a, b));
                sum += nearest;
                squares += nearest * nearest;
            }
            double mean = sum / chosen.Count;
            return Math.Sqrt(squares / chosen.Count - mean * mean) / mean;
        }

        static void CheckNodes(SampledPoints sampled, NodeSizes sizes)
        {
            var counts = new int[sampled.Nodes.Length];
            foreach (int node in sampled.NodeOfPoint)
                counts[node]++;
            for (int n = 0; n < counts.Length; n++)
            {
                var node = sampled.Nodes[n];
                Assert.That(node.OwnCount, Is.EqualTo(counts[n]));
                Assert.That(node.OwnCount, Is.InRange(1, sizes.MaxPointsPerNode));
                Assert.That(node.Parent, Is.LessThan(n));
                if (n > 0)
                    Assert.That(node.Parent, Is.GreaterThanOrEqualTo(0));
            }
        }
    }
}
