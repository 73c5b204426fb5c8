namespace FastPoints.Cli.Convert
{
    /// <summary>How evenly the sampled points of one level lie. Lengths are in CRS units.</summary>
    public sealed class LevelQuality
    {
        const double FarthestSpacings = 3;

        public required int Level { get; init; }
        public required int Nodes { get; init; }
        public required long Points { get; init; }
        public required double Spacing { get; init; }
        public required double MinDistance { get; init; }
        public required double ShareNearAcrossChunks { get; init; }
        public required double Variation { get; init; }

        public static List<LevelQuality> Measure(string cloud, CliRun run)
        {
            var verified = new VerifyResult();
            run.RunSteps(VerifyCloud.Run(cloud, Array.Empty<PointReader>(), verified, run.Progress));
            var spacings = new List<LevelSpacing>();
            if (verified.Ok)
                run.RunSteps(MeasureSpacing.Run(cloud, spacings));
            var result = new List<LevelQuality>();
            using var folder = CloudFolder.Open(cloud);
            for (int level = 0; level < verified.Levels.Count; level++)
            {
                var at = verified.Levels[level];
                if (at.SampledPoints < 2)
                    continue;
                var near = level < spacings.Count ? spacings[level] : LevelSpacing.None;
                result.Add(new LevelQuality
                {
                    Level = level,
                    Nodes = at.Nodes,
                    Points = at.SampledPoints,
                    Spacing = at.Spacing,
                    MinDistance = near.MinDistance,
                    ShareNearAcrossChunks = near.NearAcrossChunks / (double)at.SampledPoints,
                    Variation = VariationOf(folder, level, at.Spacing, run),
                });
            }
            return result;
        }

        static unsafe double VariationOf(CloudFolder folder, int level, double spacing, CliRun run)
        {
            var points = new List<double3>();
            Load(folder, 0, level - 1, points, run);
            int own = points.Count;
            Load(folder, level, level, points, run);
            using var all = new NativeArray<double3>(points.ToArray(), Allocator.Persistent);
            using var scratch = new NativeArray<int>(NeighbourGrid.ScratchOf(points.Count), Allocator.Persistent);
            var near = new NeighbourGrid((double3*)all.GetUnsafeReadOnlyPtr(), points.Count, FarthestSpacings * spacing,
                (int*)scratch.GetUnsafePtr());
            near.Add(0, points.Count);
            double sum = 0, squares = 0;
            long count = 0;
            for (int i = own; i < points.Count; i++)
            {
                double distance = near.DistanceOf(i);
                if (!double.IsFinite(distance))
                    continue;
                count++;
                sum += distance;
                squares += distance * distance;
            }
            double mean = sum / count;
            return Math.Sqrt(Math.Max(0, squares / count - mean * mean)) / mean;
        }

        static unsafe void Load(CloudFolder folder, int first, int last, List<double3> points, CliRun run)
        {
            using var selection = new SampledNodes(folder, first, last);
            if (selection.Points == 0)
                return;
            var schema = LoadNodes.SchemaFor(folder);
            using var batch = new PointBatch(schema, checked((int)selection.Points), Allocator.Persistent);
            run.RunSteps(LoadNodes.Run(folder, selection, batch, null));
            var bytes = (byte*)batch.Bytes.GetUnsafeReadOnlyPtr();
            var x = (double*)(bytes + batch.Column(schema.IndexOf(AttributeNames.X)).OffsetBytes);
            var y = (double*)(bytes + batch.Column(schema.IndexOf(AttributeNames.Y)).OffsetBytes);
            var z = (double*)(bytes + batch.Column(schema.IndexOf(AttributeNames.Z)).OffsetBytes);
            for (int i = 0; i < batch.Count; i++)
                points.Add(new double3(x[i], y[i], z[i]) * folder.Manifest.Grid.Step);
        }
    }
}
