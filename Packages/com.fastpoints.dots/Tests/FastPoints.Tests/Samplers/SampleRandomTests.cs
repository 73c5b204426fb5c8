using FastPoints.Points;
using FastPoints.Samplers;
using NUnit.Framework;

namespace FastPoints.Tests.Samplers
{
    public class SampleRandomTests
    {
        static readonly NodeSizes s_small = new NodeSizes { CellsLog2 = 4, MaxPointsPerLeaf = 100, MaxPointsPerNode = 300 };

        [TestCaseSource(typeof(SamplingClouds), nameof(SamplingClouds.All))]
        public void Sample_SmallCloud_IsExactlyTheReference(Grid3[] places)
        {
            var sampled = SampledPoints.Run(places, Sampler.Random, s_small);
            var reference = new RandomReference(sampled.Places, sampled.Priority, s_small);
            for (int i = 0; i < sampled.Places.Length; i++)
                Assert.That(sampled.IsSampled(i) ? sampled.Nodes[sampled.NodeOfPoint[i]].CellLog2 : -2,
                    Is.EqualTo(reference.CellOfPoint[i]), "point " + i);
        }

        [TestCaseSource(typeof(SamplingClouds), nameof(SamplingClouds.All))]
        public void Sample_InSlices_IsTheSame(Grid3[] places)
        {
            var whole = SampledPoints.Run(places, Sampler.Random, s_small);
            var sliced = SampledPoints.Run(places, Sampler.Random, s_small, 50);
            Assert.That(sliced.NodeOfPoint, Is.EqualTo(whole.NodeOfPoint));
            Assert.That(sliced.Nodes, Is.EqualTo(whole.Nodes));
        }

        // 16 cells along an edge: of 280 places in a volume a node would take all but a few, of so many on two lines 64 at most.
        [TestCase(Sampler.Random), TestCase(Sampler.Poisson)]
        public void Sample_CubeThatANodeWouldTakeAlmostWhole_IsALeaf(Sampler sampler)
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
    }
}
