using FastPoints.Sources;
using NUnit.Framework;
using Unity.Mathematics;
using Random = System.Random;

namespace FastPoints.Tests.Sources
{
    public class PotreeNormalsTests
    {
        static float3 Unit(Random random) => math.normalize(new float3((float)random.NextDouble() - 0.5f,
            (float)random.NextDouble() - 0.5f, (float)random.NextDouble() - 0.5f));

        static byte Byte(float value) => (byte)math.clamp(math.round(value * 255), 0, 255);

        [Test]
        public void FromOctahedron_OfPackedVectors_IsWithinADegree()
        {
            var random = new Random(1);
            for (int i = 0; i < 10000; i++)
            {
                var n = Unit(random);
                var p = n / (math.abs(n.x) + math.abs(n.y) + math.abs(n.z));
                float u = p.z >= 0 ? p.x : (1 - math.abs(p.y)) * (p.x < 0 ? -1 : 1);
                float v = p.z >= 0 ? p.y : (1 - math.abs(p.x)) * (p.y < 0 ? -1 : 1);
                var got = PotreeNormals.FromOctahedron(Byte(u * 0.5f + 0.5f), Byte(v * 0.5f + 0.5f));
                Assert.That(math.dot(got, n), Is.GreaterThan(math.cos(math.radians(1f))));
            }
        }

        [Test]
        public void FromSphereMap_OfPackedVectors_IsWithinTwoDegreesExceptAtTheSeam()
        {
            var random = new Random(2);
            for (int i = 0; i < 10000; i++)
            {
                var n = Unit(random);
                float p = math.sqrt(n.z * 8 + 8);
                var got = PotreeNormals.FromSphereMap(Byte(n.x / p + 0.5f), Byte(n.y / p + 0.5f));
                Assert.That(math.dot(got, n), Is.GreaterThan(math.cos(math.radians(n.z > -0.5f ? 1.5f : 15f))), n.ToString());
            }
        }

        [Test]
        public void Decode_AnyBytes_GivesAUnitVector()
        {
            float worst = 0;
            for (int x = 0; x < 256; x++)
                for (int y = 0; y < 256; y++)
                {
                    worst = math.max(worst, math.abs(1 - math.length(PotreeNormals.FromOctahedron((byte)x, (byte)y))));
                    worst = math.max(worst, math.abs(1 - math.length(PotreeNormals.FromSphereMap((byte)x, (byte)y))));
                }
            Assert.That(worst, Is.LessThan(1e-5f));
        }
    }
}
