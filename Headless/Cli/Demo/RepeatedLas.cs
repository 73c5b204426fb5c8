namespace FastPoints.Cli.Demo;

/// <summary>Repeats a LAS file's points side by side along x into one larger file: whole records, so that every attribute and
/// every header record is kept; shifts are whole grid steps, so that nothing is rounded.</summary>
public static class RepeatedLas
{
    const int BufferBytes = 1 << 20;

    public static long Write(string source, string destination, int times, StageProgress progress, CancellationToken cancellation)
    {
        long points, pointsOffset;
        int recordBytes;
        using (var reader = PointReaders.Open(source))
        {
            if (reader.Info.Format != "LAS")
                throw new PointCloudException(FailureCode.Unsupported, source, -1,
                    "only LAS files are tiled, this is " + reader.Info.Format);
            points = reader.PointCount;
            recordBytes = reader.Info.RecordBytes;
        }
        if (points == 0)
            throw new PointCloudException(FailureCode.BadInput, source, -1, "has no points to repeat");
        using var input = new FileStream(source, FileMode.Open, FileAccess.Read, FileShare.Read, 1);
        var fixedPart = new byte[375];
        input.ReadAtLeast(fixedPart, fixedPart.Length, throwOnEndOfStream: false);
        pointsOffset = BinaryPrimitives.ReadUInt32LittleEndian(fixedPart.AsSpan(LasHeader.At.PointsOffset));
        var head = new byte[pointsOffset];
        input.Position = 0;
        input.ReadExactly(head);

        progress.Begin("measure");
        var (minX, maxX) = MeasureX(input, pointsOffset, points, recordBytes, progress, cancellation);
        long shift = (long)maxX - minX + 1;
        if (maxX + shift * (times - 1) > int.MaxValue)
            throw new UsageException(string.Create(CultureInfo.InvariantCulture,
                $"--times {times}: beyond what 32-bit coordinates hold; this file has room for "
                    + $"{1 + (int.MaxValue - maxX) / shift}"));
        long total = checked(points * times);
        long tailOffset = PatchHeader(source, head, points, times, (pointsOffset, recordBytes), shift * (times - 1));

        progress.Begin("tile");
        using var output = new OutputFile(destination);
        OutputFile.WithFileErrors(destination, () =>
        {
            output.Stream.Write(head);
            var buffer = new byte[BufferBytes / recordBytes * recordBytes];
            for (int copy = 0; copy < times; copy++)
            {
                input.Position = pointsOffset;
                for (long left = points * recordBytes; left > 0;)
                {
                    cancellation.ThrowIfCancellationRequested();
                    int bytes = (int)Math.Min(left, buffer.Length);
                    input.ReadExactly(buffer, 0, bytes);
                    for (int at = 0; at < bytes; at += recordBytes)
                    {
                        var x = buffer.AsSpan(at, 4);
                        BinaryPrimitives.WriteInt32LittleEndian(x,
                            (int)(BinaryPrimitives.ReadInt32LittleEndian(x) + shift * copy));
                    }
                    output.Stream.Write(buffer, 0, bytes);
                    left -= bytes;
                    long done = points * (copy + 1) - left / recordBytes;
                    progress.Report((double)done / total, done, done * recordBytes);
                }
            }
            if (tailOffset > 0)
            {
                input.Position = tailOffset;
                input.CopyTo(output.Stream);
            }
        });
        output.Commit();
        progress.End();
        return total;
    }

    static (int Min, int Max) MeasureX(FileStream input, long pointsOffset, long points, int recordBytes, StageProgress progress,
        CancellationToken cancellation)
    {
        var buffer = new byte[BufferBytes / recordBytes * recordBytes];
        int min = int.MaxValue, max = int.MinValue;
        input.Position = pointsOffset;
        for (long left = points * recordBytes; left > 0;)
        {
            cancellation.ThrowIfCancellationRequested();
            int bytes = (int)Math.Min(left, buffer.Length);
            input.ReadExactly(buffer, 0, bytes);
            for (int at = 0; at < bytes; at += recordBytes)
            {
                int x = BinaryPrimitives.ReadInt32LittleEndian(buffer.AsSpan(at));
                min = Math.Min(min, x);
                max = Math.Max(max, x);
            }
            left -= bytes;
            long done = points - left / recordBytes;
            progress.Report((double)done / points, done, done * recordBytes);
        }
        return (min, max);
    }

    /// <returns>Offset of what follows the points in the source (waveforms, EVLRs), or 0.</returns>
    internal static long PatchHeader(string source, byte[] head, long points, int times, (long At, int Bytes) records, long shift)
    {
        long total = checked(points * times);
        double scale = BitConverter.ToDouble(head, LasHeader.At.Scale);
        // A negative scale turns the axis around: the copies lie below.
        int grown = scale < 0 ? LasHeader.At.Bounds + sizeof(double) : LasHeader.At.Bounds;
        BitConverter.TryWriteBytes(head.AsSpan(grown), BitConverter.ToDouble(head, grown) + shift * scale);

        bool hasLongCounts = head[LasHeader.At.VersionMinor] >= 4 && head.Length >= 375;
        if (!hasLongCounts && total > uint.MaxValue)
            throw new PointCloudException(FailureCode.Unsupported, source, LasHeader.At.LegacyCount,
                "a LAS file before version 1.4 holds at most 4,294,967,295 points");
        for (int i = -1; i < 5; i++)
        {
            var count = head.AsSpan(i < 0 ? LasHeader.At.LegacyCount : LasHeader.At.LegacyByReturn + 4 * i);
            long many = (long)BinaryPrimitives.ReadUInt32LittleEndian(count) * times;
            BinaryPrimitives.WriteUInt32LittleEndian(count, total > uint.MaxValue ? 0 : (uint)many);
        }
        if (!hasLongCounts)
            return 0;
        BinaryPrimitives.WriteInt64LittleEndian(head.AsSpan(LasHeader.At.Count64), total);
        for (int i = 0; i < 15; i++)
        {
            var count = head.AsSpan(LasHeader.At.ByReturn + 8 * i);
            BinaryPrimitives.WriteUInt64LittleEndian(count, BinaryPrimitives.ReadUInt64LittleEndian(count) * (ulong)times);
        }
        long pointsEnd = records.At + points * records.Bytes;
        long tailOffset = 0;
        foreach (int field in new[] { LasHeader.At.WaveformOffset, LasHeader.At.EvlrOffset })
        {
            long start = BinaryPrimitives.ReadInt64LittleEndian(head.AsSpan(field));
            if (start < pointsEnd)
                continue;
            BinaryPrimitives.WriteInt64LittleEndian(head.AsSpan(field), start + (total - points) * records.Bytes);
            tailOffset = pointsEnd;
        }
        return tailOffset;
    }
}
