using FastPoints.Octree;
using FastPoints.Points;
using NUnit.Framework;

namespace FastPoints.Tests.Octree
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
    }
}
