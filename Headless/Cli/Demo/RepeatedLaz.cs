namespace FastPoints.Cli.Demo;

/// <summary>Repeats a LAZ file's points side by side along x without decoding them: all coordinates of a chunk but the first are
/// differences, so that a chunk is moved by four of its bytes.</summary>
/// <remarks>The tiles are as far apart as the header's bounds say; extended VLRs stay behind.</remarks>
public static class RepeatedLaz
{
    const int ChunkPointsOffset = 12; // Offset of the points per chunk in the payload of the LASzip VLR.

    public static long Write(string path, string destination, int times, StageProgress progress, CancellationToken cancellation)
    {
        using var source = RandomAccessFile.Open(path);
        var las = LasFile.Read(source);
        var format = LazFormat.Read(las);
        if (format.Compressor != LazCompressor.PointwiseChunked && !format.IsLayered)
            throw new PointCloudException(FailureCode.Unsupported, path, -1, "only LAZ files of chunks are tiled to LAZ");
        long pointsOffset = (long)las.Header.PointsOffset;
        var table = LazChunkTable.Read(source, format, las.Info, pointsOffset);
        if (table.IsLost || table.Chunks.Count == 0)
            throw new PointCloudException(FailureCode.BadInput, path, pointsOffset, "has no chunk table, or no points to repeat");
        long points = table.Chunks.PointCount, bytes = 0;
        for (int c = 0; c < table.Chunks.Count; c++)
            bytes += table.Chunks[c].Bytes;

        byte[] head = source.Read(0, checked((int)pointsOffset), "header").Bytes;
        double scale = las.Header.Scale.x;
        long shift = 1 + (long)Math.Ceiling((las.Header.Max.x - las.Header.Min.x) / Math.Abs(scale));
        double farthest = Math.Abs((las.Header.Max.x - las.Header.Offset.x) / scale) + shift * (times - 1.0);
        if (!(farthest <= int.MaxValue))
            throw new UsageException(string.Create(CultureInfo.InvariantCulture,
                $"--times {times}: beyond what 32-bit coordinates hold"));
        if (las.Header.VersionMinor >= 3 && head.Length >= LasHeader.At.EvlrOffset)
            Array.Clear(head, LasHeader.At.WaveformOffset, 8);
        if (las.Header.VersionMinor >= 4 && head.Length >= LasHeader.At.Count64)
            Array.Clear(head, LasHeader.At.EvlrOffset, LasHeader.At.Count64 - LasHeader.At.EvlrOffset);
        long total = checked(points * times);
        RepeatedLas.PatchHeader(path, head, points, times, default, shift * (times - 1));
        int vlrOffset = (int)las.Vlrs.Find(LazFormat.UserId, LazFormat.RecordId).DataOffset;
        BinaryPrimitives.WriteUInt32LittleEndian(head.AsSpan(vlrOffset + ChunkPointsOffset), LazFormat.VariableChunkPoints);

        progress.Begin("tile");
        using var output = new OutputFile(destination);
        OutputFile.WithFileErrors(destination, () =>
        {
            output.Stream.Write(head);
            output.Stream.Write(BitConverter.GetBytes(-1L));
            var bytesOfChunk = new List<int>();
            var pointsOfChunk = new List<int>();
            for (int copy = 0; copy < times; copy++)
            {
                for (int c = 0; c < table.Chunks.Count; c++)
                {
                    var chunk = table.Chunks[c];
                    cancellation.ThrowIfCancellationRequested();
                    byte[] content = source.Read(chunk.Offset, checked((int)chunk.Bytes), "chunk").Bytes;
                    int x = BinaryPrimitives.ReadInt32LittleEndian(content);
                    BinaryPrimitives.WriteInt32LittleEndian(content, checked((int)(x + shift * copy * Math.Sign(scale))));
                    output.Stream.Write(content);
                    bytesOfChunk.Add(content.Length);
                    pointsOfChunk.Add(checked((int)chunk.Points));
                }
                progress.Report((copy + 1.0) / times, points * (copy + 1), bytes * (copy + 1));
            }
            long tableOffset = output.Stream.Position;
            output.Stream.Write(LazChunkTable.ToBytes(bytesOfChunk, pointsOfChunk));
            output.Stream.Position = pointsOffset;
            output.Stream.Write(BitConverter.GetBytes(tableOffset));
        });
        output.Commit();
        progress.End();
        return total;
    }
}
