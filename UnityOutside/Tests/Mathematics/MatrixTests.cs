using Random = Unity.Mathematics.Random;

namespace UnityOutside.Tests.Mathematics;

public sealed class MatrixTests
{
    [Test]
    public void Inverse_OfRandomMatrices_TimesTheMatrixIsIdentity()
    {
        var random = new Random(11);
        for (int i = 0; i < 50; i++)
        {
            var m = new double3x3(random.NextDouble3(-2, 2), random.NextDouble3(-2, 2), random.NextDouble3(-2, 2));
            if (System.Math.Abs(math.determinant(m)) < 0.05)
                continue;
            double3x3 product = math.mul(math.inverse(m), m);
            for (int column = 0; column < 3; column++)
                Assert.That(math.cmax(math.abs(product[column] - double3x3.identity[column])), Is.LessThan(1e-10));
        }
    }

    [Test]
    public void DeterminantAndInverse_OfTenths_RoundLikeUnity()
    {
        var m = new double3x3(5.1, -0.5, -5.7, 1.6, -0.1, -8.4, 9.7, -0.9, 0.2);

        Assert.That(math.determinant(m), Is.EqualTo(4.921000000000006));
        Assert.That(math.inverse(m).c0.x, Is.EqualTo(-1.5403373298110123));
    }

    [Test]
    public void Constructor_OfNineNumbers_IsByRows()
    {
        var m = new double3x3(1, 2, 3, 4, 5, 6, 7, 8, 9);

        Assert.That(m.c0, Is.EqualTo(new double3(1, 4, 7)));
        Assert.That(math.transpose(m).c0, Is.EqualTo(new double3(1, 2, 3)));
        Assert.That(math.mul(m, new double3(1, 0, 1)), Is.EqualTo(new double3(4, 10, 16)));
        Assert.That(math.mul(m, m).c0, Is.EqualTo(new double3(30, 66, 102)));
    }

    [Test]
    public void Mul_OfFourColumns_SumsThem()
    {
        var m = new double4x4(new double4(1, 5, 9, 13), new double4(2, 6, 10, 14),
            new double4(3, 7, 11, 15), new double4(4, 8, 12, 16));

        Assert.That(math.mul(m, new double4(1, 0, 0, 1)), Is.EqualTo(new double4(5, 13, 21, 29)));
        Assert.That(new double4x4(float4x4.Translate(new float3(1, 2, 3))).c3, Is.EqualTo(new double4(1, 2, 3, 1)));
    }
}
