using FastPoints.Cli.Preview;

namespace FastPoints.HostTests.Cli;

public sealed class CellThinningTests
{
    static PointBatch Heap()
    {
        var schema =
            new PointSchema([new(AttributeNames.X, AttributeType.Float64), new(AttributeNames.Y, AttributeType.Float64),
            new(AttributeNames.Z, AttributeType.Float64)]);
        var batch = new PointBatch(schema, 1010, Allocator.Persistent) { Count = 1010 };
        NativeArray<double> x = batch.Column<double>(AttributeNames.X), y = batch.Column<double>(AttributeNames.Y),
            z = batch.Column<double>(AttributeNames.Z);
        for (int i = 0; i < 1010; i++)
            (x[i], y[i], z[i]) = (i < 1000 ? 0 : 10 * (i - 999), 0, 0);
        return batch;
    }

    static double[] Take(int wanted)
    {
        using var points = Heap();
        var ranges = new DisplayRanges { Robust = new BoundsGeo(default, new(100, 0, 0)) };
        using var chosen = CellThinning.Thin(points, PositionTransform.Identity, ranges, wanted);
        return [.. chosen.Column<double>(AttributeNames.X).ToArray().Take(chosen.Count)];
    }

    [Test]
    public void Take_MoreThanCells_FillsEachCellFirst()
    {
        var x = Take(500);
        Assert.That(x, Has.Length.EqualTo(500));
        Assert.That(x.Distinct().Count(), Is.EqualTo(11));
    }

    [Test]
    public void Take_AllOrMore_IsAll([Values(1010, 5000)] int wanted) => Assert.That(Take(wanted), Has.Length.EqualTo(1010));
}
