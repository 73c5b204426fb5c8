namespace FastPoints.Cli.Stability;

public static class StabilityCases
{
    const int Side = 100000;

    public static IReadOnlyList<StabilityCase> All { get; } =
    [
        new("no point", (folder, n) => Las(folder, 0, i => default)),
        new("one point", (folder, n) => Las(folder, 1, i => new int3(5, 6, 7))),
        new("two points", (folder, n) => Las(folder, 2, i => new int3(i * 1000, 0, 0))),
        new("all equal", (folder, n) => Las(folder, n, i => new int3(5, -6, 7))),
        new("60,000 equal in a cloud",
            (folder, n) => Las(folder, n + 60000, i => i < 60000 ? new int3(777, 778, 779) : Uniform(i))),
        new("collinear", (folder, n) => Las(folder, n, i => new int3(i * 3, i * 3, i * 3))),
        new("planar", (folder, n) => Las(folder, n, i => new int3(Uniform(i).xy, -12345))),
        new("lattice", (folder, n) => Lattice(folder, n)),
        new("uniform in a cube", (folder, n) => Las(folder, n, Uniform)),
        // 99.9 % in 1e-4 of the extent.
        new("teapot in a stadium", (folder, n) => Las(folder, n, i => i % 1000 == 0
            ? Uniform(i) * 10000
            : Uniform(i) + new int3(500000000, 400000000, 300000000))),
        new("density of a million to one", (folder, n) => Las(folder, n, Terrestrial)),
        new("outlier at 1e9 m beside 0.1 mm",
            (folder, n) => new StabilityInput([StabilityFiles.Ply(folder, "cloud", n, i => i == n / 2
            ? new double3(1e9, -1e9, 1e9)
            : new double3(Uniform(i)) * 1e-4)], n)),
        new("NaN and infinities", (folder, n) => NonFinite(folder, n)),
        new("X at the limits of integers", (folder, n) => Las(folder, n, i => i < 4
            ? new int3((i & 1) == 0 ? int.MinValue : int.MaxValue, (i & 2) == 0 ? int.MinValue : int.MaxValue, 0)
            : Uniform(i))),
        new("UTM offset of 1e7, scale of 0.1 mm", (folder, n) => Las(folder, n, i => Uniform(i) * 100, 1e-4, 1e7)),
        new("degrees, steps of 1e-7",
            (folder, n) => Las(folder, n, i => Uniform(i) + new int3(134000000, 525000000, 0), 1e-7)),
        new("extent of a micrometre", (folder, n) => Las(folder, n, i => new int3(Uniform(i).xyz % 1000), 1e-9)),
        new("points on the maximum bound",
            (folder, n) => Las(folder, n, i => i % 2 == 0 ? new int3(1 << 17, 1 << 17, 1 << 17) : Uniform(i))),
        new("header bounds zero", (folder, n) => Claim(Las(folder, n, Uniform), p => StabilityFiles.ClaimBounds(p, 0))),
        new("header bounds too small",
            (folder, n) => Claim(Las(folder, n, Uniform), p => StabilityFiles.ClaimBounds(p, 400))),
        new("header bounds NaN", (folder, n) => Claim(Las(folder, n, Uniform),
            p => StabilityFiles.ClaimBounds(p, double.NaN))),
        new("header counts too high", (folder, n) => Claim(Las(folder, n, Uniform),
            p => StabilityFiles.ClaimCount(p, uint.MaxValue))),
        new("header counts too low", (folder, n) =>
            // What the header does not count is not read; the reader warns of it.
            Claim(Las(folder, n, Uniform), p => StabilityFiles.ClaimCount(p, (uint)n / 2)) with { Points = n / 2 }),
        new("random order", (folder, n) => Las(folder, n, i => Surface((int)(Random(i).NextUInt() % (uint)n), n))),
        new("spiral that fools the sample", (folder, n) => Las(folder, n, i => Spiral(i, n))),
        new("tiles of different scales and offsets", (folder, n) => Tiles(folder, n)),
        new("many tiny files", (folder, n) => TinyFiles(folder, n)),
        new("header that breaks off", (folder, n) => Truncated(folder)) { MustSucceed = false },
        new("target that cannot be written", (folder, n) => Las(folder, 100, Uniform))
        {
            MustSucceed = false,
            Target = folder => Path.Combine(folder, "cloud.las", "cloud.fastpoints"),
        },
        new("two builds of one target", (folder, n) => Las(folder, n, Uniform)) { IsBuiltTwice = true },
    ];

    static StabilityInput Las(string folder, int count, Func<int, int3> positionOf, double scale = 0.01, double offset = 0) =>
        new([StabilityFiles.Las(folder, "cloud", count, scale, offset, positionOf)], count);

    static Unity.Mathematics.Random Random(int i) => Unity.Mathematics.Random.CreateFromIndex((uint)i);
    static int3 Uniform(int i) => Random(i).NextInt3(Side);

    static int3 Surface(int i, int count)
    {
        int perLine = (int)Math.Sqrt(count) + 1;
        return new int3(i % perLine * 10, i / perLine * 10, (int)(300 * Math.Sin(i % perLine * 0.05)));
    }

    static int3 Terrestrial(int i)
    {
        var random = Random(i);
        double range = 1000 * Math.Pow(1000, random.NextDouble());
        double angle = random.NextDouble() * 2 * Math.PI;
        return new int3((int)(range * Math.Cos(angle)), (int)(range * Math.Sin(angle)), random.NextInt(3));
    }

    static int3 Spiral(int i, int count)
    {
        if (i < count / 2)
            return Random(i).NextInt3(500);
        double turn = (i - count / 2) * 40.0 / count * 2 * Math.PI, radius = Side * (i - count / 2) * 2.0 / count;
        return new int3((int)(radius * Math.Cos(turn)), (int)(radius * Math.Sin(turn)), i % 100);
    }

    static StabilityInput Lattice(string folder, int count)
    {
        int edge = Math.Max(2, (int)Math.Round(Math.Pow(count, 1 / 3.0)));
        return Las(folder, edge * edge * edge, i => new int3(i % edge, i / edge % edge, i / edge / edge) * 64);
    }

    static StabilityInput NonFinite(string folder, int count)
    {
        int leftOut = (count + 99) / 100;
        string file = StabilityFiles.Ply(folder, "cloud", count, i =>
        {
            var position = new double3(Uniform(i)) / 64;
            double wrong = (i / 100 % 3) switch { 0 => double.NaN, 1 => double.PositiveInfinity, _ => double.NegativeInfinity };
            if (i % 100 == 0)
                position[i / 300 % 3] = wrong;
            return position;
        });
        return new StabilityInput([file], count, leftOut);
    }

    static StabilityInput Claim(StabilityInput input, Action<string> patch)
    {
        patch(input.Files[0]);
        return input;
    }

    static StabilityInput Tiles(string folder, int count)
    {
        double[] scales = [0.01, 0.001, 0.0025, 0.02];
        var files = new string[scales.Length];
        for (int t = 0; t < files.Length; t++)
        {
            int first = t * (count / 4);
            files[t] = StabilityFiles.Las(folder, "tile" + t, count / 4, scales[t], t * 7.5, i => Uniform(first + i));
        }
        return new StabilityInput(files, count / 4 * 4);
    }

    static StabilityInput TinyFiles(string folder, int count)
    {
        const int inFile = 20;
        var files = new string[Math.Min(10000, Math.Max(2, count / inFile))];
        for (int f = 0; f < files.Length; f++)
        {
            int first = f * inFile;
            files[f] = StabilityFiles.Las(folder, "tiny" + f, inFile, 0.01, 0, i => Uniform(first + i));
        }
        return new StabilityInput(files, files.Length * inFile);
    }

    static StabilityInput Truncated(string folder)
    {
        string file = StabilityFiles.Las(folder, "cloud", 100, 0.01, 0, Uniform);
        using var stream = new FileStream(file, FileMode.Open);
        stream.SetLength(100);
        return new StabilityInput([file], 0);
    }
}
