namespace FastPoints.Cli.Demo;

/// <summary>A LAZ file's points as plain LAS records, in their order: attributes, grid and WKT are kept, other header
/// records are not.</summary>
public static class LasUnpacking
{
    sealed class Appender(LasWriter writer) : IBlockConsumer
    {
        public JobHandle Schedule(BlockRead read, int slot, JobHandle decoded) => decoded;
        public void Completed(BlockRead read, int slot) => writer.Append(read.Points);
    }

    public static void Write(PointReader reader, string destination, CliRun run)
    {
        var info = reader.Info;
        var transform = info.Transform;
        var settings = new LasWriterSettings
        {
            PointFormat = info.PointFormat,
            VersionMinor = 4,
            Scale = transform.Scale,
            Offset = transform.Offset,
            Wkt = info.Crs.Wkt,
        };
        var standard = new LasRecordLayout(LasPointFormat.Of(info.PointFormat),
            LasPointFormat.Of(info.PointFormat).RecordBytes, Array.Empty<PointField>());
        var extra = new List<PointAttribute>();
        foreach (var attribute in info.Schema)
            if (!standard.Fields.TryFind(attribute.Name, out _))
                extra.Add(attribute);
        settings.ExtraBytes = extra.ToArray();

        run.Progress.Begin("unpack");
        if (!reader.BlocksAreKnown)
            run.RunSteps(reader.IndexBlocks());
        using var writer = LasWriter.Create(destination, settings);
        run.RunSteps(SourceScan.Run(reader, info.Schema, new Appender(writer),
            SourceScan.SlotsFor(reader, info.Schema), run.Progress));
        writer.Complete();
        run.Progress.End();
    }
}
