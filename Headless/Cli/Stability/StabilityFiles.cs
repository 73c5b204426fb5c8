namespace FastPoints.Cli.Stability;

static class StabilityFiles
{
    const int RecordBytes = 26;
    const int CountAt = 107;
    const int BoundsAt = 179;

    /// <summary>A coloured LAS 1.2 file, point format 2.</summary>
    public static unsafe string Las(string folder, string name, int count, double scale, double offset, Func<int,
        int3> positionOf)
    {
        string path = Path.Combine(folder, name + ".las");
        var settings = new LasWriterSettings
        {
            VersionMinor = 2,
            PointFormat = 2,
            Scale = new double3(scale, scale, scale),
            Offset = new double3(offset, offset, 0),
        };
        const int atOnce = 10000;
        var records = new byte[atOnce * RecordBytes];
        using var writer = LasWriter.Create(path, settings);
        for (int first = 0; first < count; first += atOnce)
        {
            int some = Math.Min(atOnce, count - first);
            fixed (byte* start = records)
            {
                for (int i = 0; i < some; i++)
                {
                    byte* record = start + i * RecordBytes;
                    *(int3*)record = positionOf(first + i);
                    ((ushort*)record)[6] = (ushort)(first + i);
                    for (int c = 0; c < 3; c++)
                        ((ushort*)record)[10 + c] = (ushort)(((first + i) * (c + 3) & 255) * 257);
                }
            }
            writer.AppendRecords(records, some);
        }
        writer.Complete();
        return path;
    }

    public static void ClaimCount(string path, uint count) => Patch(path, CountAt, BitConverter.GetBytes(count));

    public static void ClaimBounds(string path, double value)
    {
        for (int i = 0; i < 6; i++)
            Patch(path, BoundsAt + i * sizeof(double), BitConverter.GetBytes(value));
    }

    public static string Ply(string folder, string name, int count, Func<int, double3> positionOf)
    {
        string path = Path.Combine(folder, name + ".ply");
        using var file = new BinaryWriter(File.Create(path));
        file.Write(System.Text.Encoding.ASCII.GetBytes("ply\nformat binary_little_endian 1.0\nelement vertex " + count
            + "\nproperty double x\nproperty double y\nproperty double z\nend_header\n"));
        for (int i = 0; i < count; i++)
        {
            var position = positionOf(i);
            file.Write(position.x);
            file.Write(position.y);
            file.Write(position.z);
        }
        return path;
    }

    static void Patch(string path, long at, byte[] bytes)
    {
        using var file = new FileStream(path, FileMode.Open);
        file.Position = at;
        file.Write(bytes);
    }
}
