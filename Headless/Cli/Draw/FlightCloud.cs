namespace FastPoints.Cli.Draw;

sealed record FlightCloud(PicturePlan Plan, DisplayRanges Ranges, int Number)
{
    public required CloudCrs Crs { get; init; }

    const int PointsToPlanWith = DrawConvertedCloud.PointsToPlanWith, PxOfDegrees = 3;

    /// <param name="plansByManifest">Colours and bounds are those that a converted cloud's manifest has, as in scenes, if it has
    /// any: no point is read for them.</param>
    internal static FlightCloud Add(string path, StreamContext stream, PictureOptions options, CancellationToken cancellation,
        bool plansByManifest = false) =>
        CloudFolder.IsCloud(path) || !SourcePath.IsRemote(path) && !Path.Exists(path)
            ? AddFolder(path, stream, options, plansByManifest, cancellation)
            : AddSource(PointReaders.Open(path), stream, options, cancellation);

    internal static FlightCloud AddSource(PointReader reader, StreamContext stream, PictureOptions options,
        CancellationToken cancellation)
    {
        try
        {
            if (reader.Tree == null)
                return AddSample(reader, stream, options, cancellation);
            JobCoroutine.RunToEnd(TreeSource.ReadTop(reader), cancellation);
            LookSettings.RequireStreamable(options, reader.Info.Schema, reader.Info.Path);
            var ranges = new DisplayRanges { Units = reader.Info.Crs.Units };
            using (var batch = ReadTop(reader, options.AttributesToMeasure(), cancellation))
                JobCoroutine.RunToEnd(ranges.Measure(batch, reader.Info.Transform, options.UpAxis), cancellation);
            var source = new TreeSource(reader,
                CloudLooks.PlanesFor(ranges.Resolve(options.Color), !options.HiddenClasses.IsEmpty, false));
            var plan = new PicturePlan(options, ranges, source.Grid.TransformFromCorner(source.Root.Corner));
            return new FlightCloud(plan, ranges, stream.Add(source, CloudPlacement.Geo(source.Grid, source.Root)))
            {
                Crs = reader.Info.Crs.ToCloudCrs(),
            };
        }
        catch
        {
            reader.Dispose();
            throw;
        }
    }

    /// <summary>Default sizes: the distance between points. Distances in degrees are not lengths.</summary>
    internal static void SetSize(PictureOptions options, params string[] clouds)
    {
        if (options.PointSizePx >= 1 || options.ColorAttribute != null)
            return;
        if (clouds.Any(IsInDegrees))
            options.PointSizePx = PxOfDegrees;
        else
            options.SizeInWorld ??= PointSize.Adaptive();
    }

    static bool IsInDegrees(string cloud)
    {
        if (!CloudFolder.IsCloud(cloud))
            return false;
        using var folder = CloudFolder.Open(cloud);
        return folder.Manifest.Crs.Units.IsInDegrees;
    }

    static FlightCloud AddSample(PointReader reader, StreamContext stream, PictureOptions options,
        CancellationToken cancellation)
    {
        LookSettings.RequireStreamable(options, reader.Info.Schema, reader.Info.Path);
        var settings = new PreviewOptions
        {
            Picture = options,
            Points = (int)Math.Min(stream.Settings.Selection.PointBudget, int.MaxValue),
        };
        SampleReader? sample = null;
        DisplayRanges ranges;
        using (reader)
        using (var preview = new PreviewPicture(reader, settings))
        {
            JobCoroutine.RunToEnd(preview.TakeSample(new StageProgress()), cancellation);
            JobCoroutine.RunToEnd(preview.PlanPicture(), cancellation);
            ranges = preview.Ranges;
            JobCoroutine.RunToEnd(SampleReader.Copy(preview.Sample, reader.Info.Path, copied => sample = copied), cancellation);
        }
        var source = new TreeSource(sample!,
            CloudLooks.PlanesFor(ranges.Resolve(options.Color), !options.HiddenClasses.IsEmpty, false));
        return new FlightCloud(new PicturePlan(options, ranges, source.Grid.TransformFromCorner(source.Root.Corner)), ranges,
            stream.Add(source, CloudPlacement.Geo(source.Grid, source.Root)))
        {
            Crs = reader.Info.Crs.ToCloudCrs(),
        };
    }

    static FlightCloud AddFolder(string path, StreamContext stream, PictureOptions options, bool plansByManifest,
        CancellationToken cancellation)
    {
        var folder = CloudFolder.Open(path);
        try
        {
            LookSettings.RequireStreamable(options, folder.Manifest.Attributes, path);
            var edits = EditPlan.Of(folder, out var refused);
            var transform = folder.Manifest.Grid.TransformFromCorner(folder.Manifest.Root.Corner);
            var ranges = plansByManifest && folder.Manifest.DisplayRanges != null ? DisplayRanges.Of(folder.Manifest)
                : MeasureRanges(folder, edits, options, cancellation);
            var plan = new PicturePlan(options, ranges, transform);
            var source = new FolderSource(folder,
                CloudLooks.PlanesFor(plan.Mode, !options.HiddenClasses.IsEmpty, plan.LitLevel > 0 && !options.Shadows))
            {
                Edits = edits,
                Refused = refused,
            };
            return new FlightCloud(plan, ranges, stream.Add(source, CloudPlacement.Geo(source.Grid, source.Root)))
            {
                Crs = folder.Manifest.Crs,
            };
        }
        catch
        {
            folder.Dispose();
            throw;
        }
    }

    static DisplayRanges MeasureRanges(CloudFolder folder, EditPlan? edits, PictureOptions options,
        CancellationToken cancellation)
    {
        var ranges = new DisplayRanges { Units = folder.Manifest.Crs.Units };
        var schema = LoadNodes.SchemaFor(folder, options.AttributesToMeasure());
        using var selection = new NodeSelection(folder) { Edits = edits };
        JobCoroutine.RunToEnd(ConvertCloud.MeasureRanges(folder, selection, schema, options.UpAxis, ranges,
            batch => selection.Load(batch, null)), cancellation);
        return ranges;
    }

    static PointBatch ReadTop(PointReader reader, string[] attributes, CancellationToken cancellation)
    {
        PointBatch? top = null;
        JobCoroutine.RunToEnd(TreeTop.Read(reader, attributes, PointsToPlanWith, read => top = read), cancellation);
        return top!;
    }
}
