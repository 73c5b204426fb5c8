using FastPoints.Streaming;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Streaming
{
    public sealed class UnityLocalSpaceTests
    {
        static readonly BoundsGeo s_bounds =
            new BoundsGeo(new double3(500_000, 4_000_000, 90), new double3(500_100, 4_000_300, 110));

        [Test]
        public void Of_EachAxis_HasItsOriginAtTheFloorsMiddle([Values] UpAxis up)
        {
            var space = UnityLocalSpace.Of(s_bounds, default, up);

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
            var space = new UnityLocalSpace { Units = new CloudUnits(0.5), Up = up };

            var unity = space.FromGeo(new double3(1, 2, 3));
            Assert.That(unity, Is.EqualTo(new double3(x, y, z) * 0.5));
            Assert.That(space.ToGeo(unity), Is.EqualTo(new double3(1, 2, 3)));
            double3 Axis(double3 axis) => space.FromGeo(axis);
            double volume = math.dot(math.cross(Axis(new double3(1, 0, 0)), Axis(new double3(0, 1, 0))),
                Axis(new double3(0, 0, 1)));
            Assert.That(volume, Is.LessThan(0), "a right-handed space in a left-handed one");
        }

        [Test]
        public void FromGeo_HeightsInAnotherUnit_AreConverted([Values] UpAxis up)
        {
            var space = UnityLocalSpace.Of(s_bounds, new CloudUnits(1200.0 / 3937, 1), up);

            var size = math.abs(space.FromGeo(s_bounds.Max) - space.FromGeo(s_bounds.Min));
            var feet = s_bounds.Size * (1200 / 3937.0);
            Assert.That(size.y, Is.EqualTo(s_bounds.Size[(int)up % 3]).Within(1e-9));
            Assert.That(size.x * size.z, Is.EqualTo(feet.x * feet.y * feet.z / feet[(int)up % 3]).Within(1e-6));
        }

        // Lengths of degrees on the ellipsoid by the usual series (Snyder 1987), to a centimetre.
        [TestCase(0, 111_319.49, 110_574.28), TestCase(45, 78_846.84, 111_131.78), TestCase(-60, 55_800.00, 111_412.29)]
        public void FromGeo_Degrees_AreAsLongAsOnTheEllipsoid(double latitude, double perLongitude, double perLatitude)
        {
            var at = new double3(-123, latitude, 0);
            var space = UnityLocalSpace.Of(new BoundsGeo(at - 0.01, at + 0.01), new CloudUnits(double.NaN));

            Assert.That(space.OriginGeo.xy, Is.EqualTo(at.xy), "to a thousandth of a degree");
            Assert.That(space.Scale.x, Is.EqualTo(perLongitude).Within(0.01));
            Assert.That(space.Scale.y, Is.EqualTo(perLatitude).Within(0.01));
            Assert.That(space.Scale.z, Is.EqualTo(1));
            var position = new double3(-122.998765, latitude + 0.0012345, 7);
            Assert.That(math.cmax(math.abs(space.ToGeo(space.FromGeo(position)) - position)), Is.LessThan(1e-12), "picked back");
        }

        // The earth drops below its tangent by length²/2R; a degree of longitude at the northern corners is shorter than in the
        // middle, which adds as much at 45 degrees.
        [TestCase(0, 1000, 0.079), TestCase(0, 10_000, 7.9), TestCase(45, 1000, 0.118)]
        [TestCase(45, 10_000, 11.8)]
        public void PlacementError_OfASquareInDegrees_IsTheEarthsCurvature(double latitude, double reach, double error)
        {
            double half = reach / math.sqrt(2) / 111_130, east = half / math.cos(math.radians(latitude));
            var centre = new double3(11, latitude, 100);
            var bounds = new BoundsGeo(centre - new double3(east, half, 0), centre + new double3(east, half, 0));

            Assert.That(new CloudUnits(double.NaN).PlacementError(bounds), Is.EqualTo(error).Within(5).Percent);
            Assert.That(new CloudUnits(1).PlacementError(bounds), Is.Zero);
        }

        [TestCase(90), TestCase(-90)]
        public void Of_DegreesAtAPole_KeepAVolume(double latitude)
        {
            var at = new double3(0, latitude, 0);
            var units = new CloudUnits(double.NaN);
            Assert.That(UnityLocalSpace.Of(new BoundsGeo(at, at), units).Scale.x, Is.GreaterThan(1));
            Assert.That(units.MetresAt(new double3(500_000, 4_000_000, 0), UpAxis.Z), Is.EqualTo(new double3(1, 1, 1)),
                "whatever the file says, these are no degrees");
        }

        [Test]
        public void Place_EachAxis_MatchesFromGeo([Values] UpAxis up)
        {
            var space = UnityLocalSpace.Of(s_bounds, new CloudUnits(0.3048, 0.9144), up);
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
