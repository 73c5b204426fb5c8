using Random = System.Random;

namespace FastPoints.HostTests.Writing;

public sealed class NumberTextTests
{
    [Test, Category("Long")]
    public void Of_MillionSeededDoubles_MatchesDotNet()
    {
        var random = new Random(7);
        for (int i = 0; i < 1_000_000; i++)
        {
            double value = BitConverter.Int64BitsToDouble(random.NextInt64(long.MinValue, long.MaxValue));
            Check(NumberText.Of(value), value.ToString("R", CultureInfo.InvariantCulture));
        }
    }

    [Test, Category("Long")]
    public void Of_MillionSeededFloats_MatchesDotNet()
    {
        var random = new Random(8);
        for (int i = 0; i < 1_000_000; i++)
        {
            float value = BitConverter.Int32BitsToSingle((int)random.NextInt64(int.MinValue, int.MaxValue));
            Check(NumberText.Of(value), value.ToString("R", CultureInfo.InvariantCulture));
        }
    }

    [Test]
    public void Of_NumbersOfClouds_MatchesDotNet()
    {
        var random = new Random(9);
        for (int i = 0; i < 50_000; i++)
        {
            double value = Math.Round(random.NextDouble() * 1e7, i % 9) + random.Next(100) * 0.001;
            Check(NumberText.Of(value), value.ToString("R", CultureInfo.InvariantCulture));
            Check(NumberText.Of((float)value), ((float)value).ToString("R", CultureInfo.InvariantCulture));
        }
    }

    /// <summary>Where .NET's shortest text does not read back, clouds had 17 digits.</summary>
    [Test]
    public void Of_PowersOfTwoAndTen_IsStable()
    {
        for (int power = -1074; power < 1024; power++)
            CheckFormer(Math.ScaleB(1, power));
        for (int power = -323; power <= 308; power++)
            CheckFormer(double.Parse("1e" + power, CultureInfo.InvariantCulture));
    }

    private static void CheckFormer(double value)
    {
        string text = value.ToString("R", CultureInfo.InvariantCulture);
        bool readsBack = double.Parse(text, CultureInfo.InvariantCulture).Equals(value);
        Check(NumberText.Of(value), readsBack ? text : value.ToString("G17", CultureInfo.InvariantCulture));
    }

    private static void Check(string got, string wanted)
    {
        // Constraints are slow, a million times.
        if (got != wanted)
            Assert.Fail(got + ", .NET has " + wanted);
    }
}
