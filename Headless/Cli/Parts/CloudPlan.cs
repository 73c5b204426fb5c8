namespace FastPoints.Cli.Parts;

sealed class CloudPlan
{
    /// <summary>Of the whole cloud, as if it were one part.</summary>
    public required BuildPart Whole { get; init; }

    /// <summary>Of the cloud, without what only its points tell.</summary>
    public required CloudManifest Manifest { get; init; }

    /// <summary>Estimates, by base cell.</summary>
    public required double[] PointsOfCell { get; init; }

    /// <summary>See <see cref="Las.LasMetadata"/>; null if the sources are not LAS files.</summary>
    public byte[]? LasMetadata { get; init; }

    /// <summary>Cubes of parts, which fill that of the cloud, in Morton order: the largest ones with so many points at most
    /// by the estimate, and no smaller than base cells.</summary>
    public GridCube[] CubesOf(double pointsPerPart)
    {
        // A part that has all points of the cloud must know it: what is stored begins at their smallest cube.
        int found = Array.FindAll(PointsOfCell, points => points > 0).Length, next = 0;
        return found < 2 ? [Whole.Cube] : CubeGroups.Of(Whole.Cube, Whole.BaseCells, cell => cell,
            _ => (long)Math.Ceiling(PointsOfCell[next++]), (long)pointsPerPart)
            .ConvertAll(g => g.Count == 1 ? Whole.BaseCells[g.First] : g.Cube).ToArray();
    }

    public static CloudPlan Of(BuildContext build, AttributeStatistics[] statistics, byte[]? lasMetadata)
    {
        var divisors = new int[statistics.Length];
        for (int a = 0; a < divisors.Length; a++)
            divisors[a] = AttributeSummary.DivisorOf(statistics[a], build.Attributes[a]);
        var whole = new BuildPart
        {
            CloudId = build.CloudId,
            Points = build.Points,
            PointsPerChunk = build.Plan.PointsPerChunk,
            Grid = build.Grid.Grid,
            RecordLayout = build.RecordLayout,
            Attributes = build.Attributes,
            Divisors = divisors,
            CloudCube = build.Map.Cube,
            Cube = build.Map.Cube,
            BaseCells = build.Map.BaseCells,
        };
        var manifest = whole.ToManifest(build.Settings.Sampler);
        CloudDescription.DescribeMeaning(build.Readers, manifest);
        return new CloudPlan
        {
            Whole = whole,
            Manifest = manifest,
            PointsOfCell = build.Map.PointsOfBaseCell,
            LasMetadata = lasMetadata,
        };
    }
}

static class PlannedParts
{
    /// <summary>The part of a smaller cube, which holds base cells.</summary>
    public static BuildPart Of(this BuildPart whole, GridCube cube)
    {
        var part = whole.Clone();
        part.Cube = cube;
        part.BaseCells = Array.FindAll(whole.BaseCells, cell => cube.ContainsAligned(cell));
        return part;
    }

    /// <summary>The part of the points outside of the whole cube: the octants around it that hold all points.</summary>
    public static BuildPart OfOutside(this BuildPart whole, in PointStatistics found)
    {
        var part = whole.Clone();
        var cells = new BaseCells(whole.CloudCube, [whole.CloudCube], RootCube.Grow(whole.CloudCube, found.Min, found.Max));
        part.Cube = cells.Root;
        part.BaseCells = cells.All;
        return part;
    }

    /// <exception cref="PointCloudException">A value is no multiple of what the plan's sample showed.</exception>
    public static void RequireDivisors(this BuildPart part, IReadOnlyList<AttributeStatistics> found, string path)
    {
        for (int a = 0; a < part.Attributes.Count; a++)
            if (!found[a].IsEmpty && (part.Divisors[a] == 257 ? found[a].Modulo257OrOfUInt16 != 0
                : (found[a].Or & (ulong)(part.Divisors[a] - 1)) != 0))
                throw new PointCloudException(FailureCode.BadInput, path, -1, "values of " + part.Attributes[a].Name +
                    " are no multiples of " + part.Divisors[a] + ", as those of the plan's sample are: " +
                    "plan again with --divisors 1");
    }

    /// <summary>What the nodes of all parts have in common; counts and ranges are not known.</summary>
    public static CloudManifest ToManifest(this BuildPart part, Sampler sampler)
    {
        var manifest = new CloudManifest
        {
            Sampler = sampler.ToString().ToLowerInvariant(),
            Root = part.CloudCube,
            CloudId = part.CloudId,
            Grid = part.Grid,
            Attributes = part.Attributes,
            Divisors = part.Divisors,
            Ranges = new CloudManifest.ValueRange[part.Attributes.Count],
        };
        Array.Fill(manifest.Ranges, new CloudManifest.ValueRange { Min = double.NaN, Max = double.NaN });
        return manifest;
    }

    /// <summary>The map to cubes of the octree that fill a cube, in Morton order.</summary>
    public static PartitionMap MapOf(GridCube cube, GridCube[] chunks)
    {
        int smallest = cube.SideLog2;
        foreach (var chunk in chunks)
            smallest = Math.Min(smallest, chunk.SideLog2);
        int levels = Math.Min(PartitionMap.MaxLevels, cube.SideLog2 - smallest), cellLog2 = cube.SideLog2 - levels, next = 0;
        var cells = new List<int>();
        var parts = new List<int>();
        Descend(cube);
        cells.AddRange(parts);
        return new PartitionMap(cube, levels, cellLog2 - smallest,
            new NativeArray<int>(cells.ToArray(), Allocator.Persistent), chunks);

        void Add(List<int> to, int sideLog2)
        {
            for (int i = 0; i < 1 << 3 * (chunks[next].SideLog2 - sideLog2); i++)
                to.Add(next);
            next++;
        }

        void Descend(GridCube part)
        {
            if (chunks[next].SideLog2 == part.SideLog2)
            {
                Add(cells, cellLog2);
                return;
            }
            if (part.SideLog2 == cellLog2)
            {
                cells.Add(~((1 << 3 * levels) + parts.Count));
                while (next < chunks.Length && part.ContainsAligned(chunks[next]))
                    Add(parts, smallest);
                return;
            }
            for (int octant = 0; octant < 8; octant++)
                Descend(part.Child(octant));
        }
    }
}
