using FastPoints.Streaming;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Streaming
{
    public sealed class UnitySpaceTests
    {
        static readonly BoundsGeo s_bounds =
            new BoundsGeo(new double3(500_000, 4_000_000, 90), new double3(500_100, 4_000_300, 110));

        [Test]
        public void Of_EachAxis_StandsOnItsFloorInTheMiddle([Values] UpAxis up)
        {
            var space = UnitySpace.Of(s_bounds, 0, up);

            double3 a = space.FromGeo(s_bounds.Min), b = space.FromGeo(s_bounds.Max);
            var low = math.min(a, b);
            Assert.That(low.y, Is.EqualTo(0).Within(0.5), "the floor, to a whole unit");
            Assert.That(math.cmax(math.abs(((a + b) / 2).xz)), Is.LessThan(0.51));
            Assert.That(math.abs(b - a).y, Is.EqualTo(s_bounds.Size[(int)up % 3]));
        }

        [TestCase(UpAxis.X, 2, 1, 3), TestCase(UpAxis.Y, 1, 2, -3), TestCase(UpAxis.Z, 1, 3, 2)]
        [TestCase(UpAxis.NegativeX, 2, -1, -3), TestCase(UpAxis.NegativeY, 1, -2, 3), TestCase(UpAxis.NegativeZ, 1, -3, -2)]
        public void FromGeo_Axes_AreLeftHandedWithUpAsY(UpAxis up, double x, double y, double z)
        {
            var space = new UnitySpace { Scale = 0.5, Up = up };

            var unity = space.FromGeo(new double3(1, 2, 3));
            Assert.That(unity, Is.EqualTo(new double3(x, y, z) * 0.5));
            Assert.That(space.ToGeo(unity), Is.EqualTo(new double3(1, 2, 3)));
            double3 Axis(double3 axis) => space.FromGeo(axis);
            double volume = math.dot(math.cross(Axis(new double3(1, 0, 0)), Axis(new double3(0, 1, 0))),
                Axis(new double3(0, 0, 1)));
            Assert.That(volume, Is.LessThan(0), "a right-handed space in a left-handed one");
        }

        [Test]
        public void Place_EachAxis_IsWhereFromGeoSays([Values] UpAxis up)
        {
            var space = UnitySpace.Of(s_bounds, 0.3048, up);
            var grid = new CloudGrid { Origin = new double3(499_000, 3_999_000, 0), Step = new double3(0.01, 0.01, 0.001) };
            var root = new GridCube { Corner = new Grid3(100_000, 100_000, 90_000) };
            var localToWorld = new double4x4(new double4(2, 0, 0, 0), new double4(0, 3, 0, 0), new double4(0, 0, 4, 0),
                new double4(10, 20, 30, 1));

            var placement = space.Place(grid, root, localToWorld);

            var geo = new double3(500_012.34, 4_000_056.78, 99.123);
            var wanted = math.mul(localToWorld, new double4(space.FromGeo(geo), 1)).xyz;
            var got = placement.OriginWorld + math.mul(placement.Linear, geo - grid.ToGeo(root.Corner));
            Assert.That(math.cmax(math.abs(got - wanted)), Is.LessThan(1e-6));
        }
    }
}
