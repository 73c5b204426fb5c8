using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.HostTests.Mathematics
{
    public sealed class MatrixTests
    {
        private const double Tolerance = 1e-12;

        [Test]
        public void Inverse_OfRandomMatrices_TimesTheMatrixIsIdentity()
        {
            var random = new Random(11);
            for (int i = 0; i < 50; i++)
            {
                var m = new double4x4(random.NextDouble4(-2, 2), random.NextDouble4(-2, 2),
                    random.NextDouble4(-2, 2), random.NextDouble4(-2, 2));
                if (System.Math.Abs(math.determinant(m)) < 0.05)
                    continue;
                double4x4 product = math.mul(m, math.inverse(m));
                for (int column = 0; column < 4; column++)
                    Assert.That(math.cmax(math.abs(product[column] - double4x4.identity[column])), Is.LessThan(1e-10));
                var small = new double3x3(m.c0.xyz, m.c1.xyz, m.c2.xyz);
                if (System.Math.Abs(math.determinant(small)) < 0.05)
                    continue;
                double3x3 smallProduct = math.mul(math.inverse(small), small);
                for (int column = 0; column < 3; column++)
                    Assert.That(math.cmax(math.abs(smallProduct[column] - double3x3.identity[column])), Is.LessThan(1e-10));
            }
        }

        [Test]
        public void DeterminantAndInverse_OfTenths_RoundAsUnitys()
        {
            var m = new double3x3(5.1, -0.5, -5.7, 1.6, -0.1, -8.4, 9.7, -0.9, 0.2);

            Assert.That(math.determinant(m), Is.EqualTo(4.921000000000006));
            Assert.That(math.inverse(m).c0.x, Is.EqualTo(-1.5403373298110123));
        }

        [Test]
        public void Constructor_OfSixteenNumbers_IsByRows()
        {
            var m = new float4x4(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16);

            Assert.That(m.c0, Is.EqualTo(new float4(1, 5, 9, 13)));
            Assert.That(math.transpose(m).c0, Is.EqualTo(new float4(1, 2, 3, 4)));
            Assert.That(math.mul(m, new float4(1, 0, 0, 1)), Is.EqualTo(new float4(5, 13, 21, 29)));
            Assert.That(math.mul(new float4(1, 0, 0, 1), m), Is.EqualTo(new float4(14, 16, 18, 20)));
        }

        [Test]
        public void Determinant_OfPermutation_IsItsSign() => Assert.That(
            math.determinant(new double4x4(0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1)), Is.EqualTo(-1.0).Within(Tolerance));

        [Test]
        public void Rotations_MatrixAndQuaternion_TurnAlike()
        {
            var v = new float3(0.3f, -0.7f, 0.2f);
            quaternion q = quaternion.EulerZXY(new float3(0.4f, -1.1f, 2.3f));
            var m = new float3x3(q);

            Near(math.mul(m, v), math.mul(q, v));
            Near(math.mul(new quaternion(m), v), math.mul(q, v));
            Near(math.mul(math.inverse(q), math.mul(q, v)), v);
            Near(math.mul(quaternion.RotateY(0.5f * math.PI), new float3(0, 0, 1)), new float3(1, 0, 0));
            Near(math.mul(float3x3.RotateY(0.5f * math.PI), new float3(0, 0, 1)), new float3(1, 0, 0));
        }

        [Test]
        public void Slerp_HalfWay_IsHalfTheAngle() => Near(
            math.mul(math.slerp(quaternion.identity, quaternion.RotateZ(1.0f), 0.5f), new float3(1, 0, 0)),
            math.mul(quaternion.RotateZ(0.5f), new float3(1, 0, 0)));

        [Test]
        public void Transform_ByTRS_ScalesTurnsAndMoves()
        {
            float4x4 m = float4x4.TRS(new float3(1, 2, 3), quaternion.RotateZ(0.5f * math.PI), new float3(2, 1, 1));

            Near(math.transform(m, new float3(1, 0, 0)), new float3(1, 4, 3));
            Near(math.rotate(m, new float3(0, 1, 0)), new float3(-1, 0, 0));
        }

        [Test]
        public void LookAt_Target_LiesOnThePositiveZAxis()
        {
            float4x4 pose = float4x4.LookAt(new float3(1, 2, 3), new float3(4, 6, 3), new float3(0, 0, 1));

            Near(math.transform(math.inverse(pose), new float3(4, 6, 3)), new float3(0, 0, 5));
        }

        [Test]
        public void PerspectiveFov_NearAndFarPlane_AreMinusOneAndOne()
        {
            float4x4 projection = float4x4.PerspectiveFov(math.radians(60.0f), 1.5f, 0.5f, 100.0f);
            float4 near = math.mul(projection, new float4(0, 0, -0.5f, 1));
            float4 far = math.mul(projection, new float4(0, 0, -100, 1));

            Assert.That(near.z / near.w, Is.EqualTo(-1.0f).Within(1e-5f));
            Assert.That(far.z / far.w, Is.EqualTo(1.0f).Within(1e-5f));
        }

        private static void Near(float3 got, float3 wanted) =>
            Assert.That(math.distance(got, wanted), Is.LessThan(1e-5f), $"{got} for {wanted}");
    }
}
