using FastPoints.Nodes;
using NUnit.Framework;
using Unity.Collections;

namespace FastPoints.Tests.Nodes
{
    [Category("Smoke")]
    public class DartGridTests
    {
        /// <summary>Vectors, plain code and a comparison with every sample find the same: of full, empty and overfull cells,
        /// and of spacings that are compared in steps and in parts.</summary>
        [Test]
        public void IsNear_AnySpacing_MatchesBruteForce([Values(1, 2, 5, 11, 12, 20, 40)] int cell)
        {
            var random = new Unity.Mathematics.Random(7);
            const int Tiles = 3;
            long edge = 1L << cell + DartGrid.TileSpacingsLog2;
            using var all = new DartGrid(Allocator.Persistent);
            var grid = all.For(cell, true);
            grid.Clear(64);
            var samples = new Grid3[900];
            int count = 0, near = 0, chained = 0;
            for (int tileNumber = 0; tileNumber < Tiles * Tiles; tileNumber++)
            {
                var corner = new Grid3((5 + tileNumber % Tiles) * edge, (7 + tileNumber / Tiles) * edge, 3 * edge);
                var tile = grid.TileOf(corner);
                grid.BeginTile(tile);
                for (int i = 0; i < 300; i++)
                {
                    var position = corner + new Grid3(Part(ref random, edge), Part(ref random, edge), Part(ref random, edge));
                    ulong dart = grid.DartOf(position, 0);
                    bool isNear = false;
                    int nearest = -1;
                    double min = double.PositiveInfinity;
                    for (int s = 0; s < count; s++)
                    {
                        double distance = DistanceSq(samples[s], position, cell, out double nearSq);
                        isNear |= distance < nearSq;
                        if (distance >= nearSq || distance >= min)
                            continue;
                        min = distance;
                        nearest = s;
                    }
                    Assert.That(grid.IsNear(dart), Is.EqualTo(isNear));
                    Assert.That(grid.IsNearPlain(dart), Is.EqualTo(isNear));
                    Assert.That(grid.Nearest(dart, out int found), Is.EqualTo(isNear));
                    if (isNear)
                        Assert.That(found, Is.EqualTo(nearest));
                    near += isNear ? 1 : 0;
                    // A third go in however near they are, in heaps.
                    if (isNear && i % 3 != 0)
                        continue;
                    for (int copies = i % 29 == 0 ? 10 : 1; copies > 0 && count < samples.Length; copies--)
                    {
                        grid.Add(dart, count);
                        samples[count++] = position;
                        chained += copies > 8 ? 1 : 0;
                    }
                }
                grid.EndTile(tile);
            }
            Assert.That(near, Is.GreaterThan(90));
            Assert.That(chained, Is.GreaterThan(5));
        }

        static long Part(ref Unity.Mathematics.Random random, long edge) => (long)(random.NextDouble() * edge);

        static double DistanceSq(Grid3 a, Grid3 b, int cell, out double nearSq)
        {
            int unit = System.Math.Max(0, cell - 11);
            double near = (1L << cell - unit) + (unit > 0 ? 2 : 0);
            nearSq = near * near;
            double x = (a.X >> unit) - (b.X >> unit), y = (a.Y >> unit) - (b.Y >> unit), z = (a.Z >> unit) - (b.Z >> unit);
            return x * x + y * y + z * z;
        }
    }
}
