using FastPoints.Sampling;
using FastPoints.Sources;

namespace FastPoints.Cli.Draw;

public static class FlightCloud
{
    const int PointsToPlanWith = DrawStored.PointsToPlanWith;

    internal static PicturePlan Add(string path, StreamContext stream, PictureOptions options, CancellationToken cancellation,
        out DisplayRanges ranges, out int number, out double metresPerUnit)
    {
        if (CloudFolder.IsCloud(path) || !Path.Exists(path))
            return AddFolder(path, stream, options, cancellation, out ranges, out number, out metresPerUnit);
        var reader = PointReaders.Open(path);
        metresPerUnit = reader.Info.Crs.MetresPerUnit;
        return AddSource(reader, stream, options, cancellation, out ranges, out number);
    }

    internal static PicturePlan AddSource(PointReader reader, StreamContext stream, PictureOptions options,
        CancellationToken cancellation, out DisplayRanges ranges, out int number)
    {
        try
        {
            if (reader.Tree == null)
                return AddSample(reader, stream, options, cancellation, out ranges, out number);
            JobCoroutine.RunToEnd(TreeSource.FindTop(reader), cancellation);
            ranges = new DisplayRanges { IsInDegrees = double.IsNaN(reader.Info.Crs.MetresPerUnit) };
            using (var batch = ReadTop(reader, ColorModes.AttributesToMeasure(options.Color), cancellation))
                JobCoroutine.RunToEnd(ranges.Measure(batch, reader.Info.Transform, options.UpAxis), cancellation);
            var source = new TreeSource(reader,
                CloudLooks.PlanesFor(ranges.Resolve(options.Color), !options.HiddenClasses.IsEmpty));
            var plan = new PicturePlan(options, ranges, source.Grid.FromCorner(source.Root.Corner));
            number = stream.Add(source, CloudPlacement.Geo(source.Grid, source.Root));
            return plan;
        }
        catch
        {
            reader.Dispose();
            throw;
        }
    }

    static PicturePlan AddSample(PointReader reader, StreamContext stream, PictureOptions options,
        CancellationToken cancellation, out DisplayRanges ranges, out int number)
    {
        var settings = new PreviewOptions
        {
            Picture = options,
            Points = (int)Math.Min(stream.Settings.Selection.PointBudget, int.MaxValue),
        };
        SampleReader sample;
        using (reader)
        using (var preview = new PreviewCloud(reader, settings))
        {
            JobCoroutine.RunToEnd(preview.TakeSample(new StageProgress()), cancellation);
            JobCoroutine.RunToEnd(preview.PlanPicture(), cancellation);
            ranges = preview.Ranges;
            sample = new SampleReader(preview.Sample, reader.Info.Path);
        }
        var source = new TreeSource(sample, CloudLooks.PlanesFor(ranges.Resolve(options.Color), !options.HiddenClasses.IsEmpty));
        number = stream.Add(source, CloudPlacement.Geo(source.Grid, source.Root));
        return new PicturePlan(options, ranges, source.Grid.FromCorner(source.Root.Corner));
    }

    static PicturePlan AddFolder(string path, StreamContext stream, PictureOptions options, CancellationToken cancellation,
        out DisplayRanges ranges, out int number, out double metresPerUnit)
    {
        var folder = CloudFolder.Open(path);
        metresPerUnit = folder.Manifest.MetresPerUnit;
        try
        {
            var schema = LoadNodes.SchemaFor(folder, ColorModes.AttributesToMeasure(options.Color));
            var transform = folder.Manifest.Grid.FromCorner(folder.Manifest.Root.Corner);
            ranges = new DisplayRanges();
            using (var selection = new NodeSelection(folder))
            {
                selection.Choose(null, PointsToPlanWith);
                using var batch = new PointBatch(schema, checked((int)selection.Points), Allocator.Persistent);
                JobCoroutine.RunToEnd(LoadNodes.Run(folder, selection, batch, null), cancellation);
                JobCoroutine.RunToEnd(ranges.Measure(batch, transform, options.UpAxis), cancellation);
            }
            var plan = new PicturePlan(options, ranges, transform);
            var source = new FolderSource(folder, CloudLooks.PlanesFor(plan.Mode, !options.HiddenClasses.IsEmpty));
            number = stream.Add(source, CloudPlacement.Geo(source.Grid, source.Root));
            return plan;
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
