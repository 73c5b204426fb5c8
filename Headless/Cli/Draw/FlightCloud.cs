using FastPoints.Sampling;
using FastPoints.Sources;

namespace FastPoints.Cli.Draw;

/// <summary>A cloud that is flown over: its number in the stream, and how it is drawn.</summary>
sealed record FlightCloud(PicturePlan Plan, DisplayRanges Ranges, int Number, double MetresPerUnit)
{
    const int PointsToPlanWith = DrawStored.PointsToPlanWith;

    internal static FlightCloud Add(string path, StreamContext stream, PictureOptions options, CancellationToken cancellation) =>
        CloudFolder.IsCloud(path) || !Path.Exists(path) ? AddFolder(path, stream, options, cancellation)
            : AddSource(PointReaders.Open(path), stream, options, cancellation);

    internal static FlightCloud AddSource(PointReader reader, StreamContext stream, PictureOptions options,
        CancellationToken cancellation)
    {
        try
        {
            if (reader.Tree == null)
                return AddSample(reader, stream, options, cancellation);
            JobCoroutine.RunToEnd(TreeSource.FindTop(reader), cancellation);
            var ranges = new DisplayRanges { IsInDegrees = double.IsNaN(reader.Info.Crs.MetresPerUnit) };
            using (var batch = ReadTop(reader, ColorModes.AttributesToMeasure(options.Color), cancellation))
                JobCoroutine.RunToEnd(ranges.Measure(batch, reader.Info.Transform, options.UpAxis), cancellation);
            var source = new TreeSource(reader,
                CloudLooks.PlanesFor(ranges.Resolve(options.Color), !options.HiddenClasses.IsEmpty));
            var plan = new PicturePlan(options, ranges, source.Grid.FromCorner(source.Root.Corner));
            return new FlightCloud(plan, ranges, stream.Add(source, CloudPlacement.Geo(source.Grid, source.Root)),
                reader.Info.Crs.MetresPerUnit);
        }
        catch
        {
            reader.Dispose();
            throw;
        }
    }

    static FlightCloud AddSample(PointReader reader, StreamContext stream, PictureOptions options,
        CancellationToken cancellation)
    {
        var settings = new PreviewOptions
        {
            Picture = options,
            Points = (int)Math.Min(stream.Settings.Selection.PointBudget, int.MaxValue),
        };
        SampleReader sample;
        DisplayRanges ranges;
        using (reader)
        using (var preview = new PreviewCloud(reader, settings))
        {
            JobCoroutine.RunToEnd(preview.TakeSample(new StageProgress()), cancellation);
            JobCoroutine.RunToEnd(preview.PlanPicture(), cancellation);
            ranges = preview.Ranges;
            sample = new SampleReader(preview.Sample, reader.Info.Path);
        }
        var source = new TreeSource(sample, CloudLooks.PlanesFor(ranges.Resolve(options.Color), !options.HiddenClasses.IsEmpty));
        return new FlightCloud(new PicturePlan(options, ranges, source.Grid.FromCorner(source.Root.Corner)), ranges,
            stream.Add(source, CloudPlacement.Geo(source.Grid, source.Root)), reader.Info.Crs.MetresPerUnit);
    }

    static FlightCloud AddFolder(string path, StreamContext stream, PictureOptions options, CancellationToken cancellation)
    {
        var folder = CloudFolder.Open(path);
        try
        {
            var schema = LoadNodes.SchemaFor(folder, ColorModes.AttributesToMeasure(options.Color));
            var transform = folder.Manifest.Grid.FromCorner(folder.Manifest.Root.Corner);
            var ranges = new DisplayRanges();
            using (var selection = new NodeSelection(folder))
            {
                selection.Choose(null, PointsToPlanWith);
                using var batch = new PointBatch(schema, checked((int)selection.Points), Allocator.Persistent);
                JobCoroutine.RunToEnd(LoadNodes.Run(folder, selection, batch, null), cancellation);
                JobCoroutine.RunToEnd(ranges.Measure(batch, transform, options.UpAxis), cancellation);
            }
            var plan = new PicturePlan(options, ranges, transform);
            var source = new FolderSource(folder, CloudLooks.PlanesFor(plan.Mode, !options.HiddenClasses.IsEmpty));
            return new FlightCloud(plan, ranges, stream.Add(source, CloudPlacement.Geo(source.Grid, source.Root)),
                folder.Manifest.MetresPerUnit);
        }
        catch
        {
            folder.Dispose();
            throw;
        }
    }

    static PointBatch ReadTop(PointReader reader, string[] attributes, CancellationToken cancellation)
    {
        PointBatch? top = null;
        JobCoroutine.RunToEnd(TreeTop.Read(reader, attributes, PointsToPlanWith, read => top = read), cancellation);
        return top!;
    }
}
