namespace FastPoints.Cli.Page;

/// <summary>FLIP of the waves' pictures against a smooth one of the octree (all points up to a picture's budget, else what it
/// has for this camera), and of that with one sample a pixel: the error of the pixels alone. Half the size of the
/// picture.</summary>
sealed record WaveFlips(List<double> OfWave, double Floor)
{
    public static WaveFlips Measure(string cloud, MeasuredSample taken, PictureOptions options, CliRun run)
    {
        run.Progress.Begin("FLIP of the waves");
        using var folder = CloudFolder.Open(cloud);
        using var selection = new NodeSelection(folder);
        var schema = LoadNodes.SchemaFor(folder, options.AttributesToMeasure());
        var ranges = options.NewRanges(folder.Manifest.Crs.Units);
        run.RunSteps(ConvertCloud.MeasureRanges(folder, selection, schema, options.UpAxis, ranges));
        int width = Math.Max(1, options.WidthPx / 2), height = Math.Max(1, options.HeightPx / 2);
        int samples = PictureCanvas.MaxSamplesPerEdge;
        selection.Choose(options.Camera!.Value.ToStreamView(width * samples, height * samples), DrawConvertedCloud.DefaultBudget);
        using var all = new PointBatch(schema, selection.PointCountOrThrow, Allocator.Persistent);
        run.RunSteps(LoadNodes.Run(folder, selection, all, null));

        RgbaImage Draw(PointBatch points, PositionTransform transform, int samplesPerEdge)
        {
            var plan = new PicturePlan(options, ranges, transform);
            using var canvas = new PictureCanvas(width, height, Allocator.Persistent, samplesPerEdge);
            run.RunSteps(SamplePicture.ChooseSize(canvas, points, plan, points.Count));
            run.RunSteps(SamplePicture.DrawAndResolve(canvas, points, plan, null));
            return canvas.ToImage();
        }
        var ofAll = folder.Manifest.Grid.TransformFromCorner(folder.Manifest.Root.Corner);
        var smooth = Draw(all, ofAll, samples);
        double FlipOf(RgbaImage picture) => FlipMap.Of(picture, smooth).Mean;
        var flips = new List<double>();
        foreach (var (wave, points) in taken.Waves)
        {
            int count = points.Count;
            points.Count = wave.Points;
            flips.Add(FlipOf(Draw(points, taken.Transform, 1)));
            points.Count = count;
        }
        run.Progress.End();
        return new WaveFlips(flips, FlipOf(Draw(all, ofAll, 1)));
    }
}
