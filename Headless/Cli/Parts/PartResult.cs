namespace FastPoints.Cli.Parts;

/// <summary>What is known of a part's points when it is built. That of a merge includes those of all that it merged: the
/// last one's is the cloud's.</summary>
sealed class PartResult
{
    /// <summary>Of the points that were read, those outside of the plan's cube too.</summary>
    public PointStatistics Statistics = PointStatistics.None;
    public AttributeStatistics[] Attributes;
    public long OwnBlockPoints; // Points of the blocks that the part owns, if they pass the filter: in sum the cloud's.

    public long OutsidePoints;
    public ulong Checksum; // Of the points in the part's chunks.

    public int MinSideLog2 = int.MaxValue;
    public long[] BytesOfPlane;

    public PartResult(int attributeCount, int planeCount)
    {
        Attributes = new AttributeStatistics[attributeCount];
        Array.Fill(Attributes, AttributeStatistics.None);
        BytesOfPlane = new long[planeCount];
    }

    public void Include(PartResult other)
    {
        Statistics.Include(other.Statistics);
        for (int a = 0; a < Attributes.Length; a++)
            Attributes[a].Include(other.Attributes[a]);
        OwnBlockPoints += other.OwnBlockPoints;
        OutsidePoints += other.OutsidePoints;
        Checksum += other.Checksum;
        Include(other.MinSideLog2, other.BytesOfPlane);
    }

    /// <summary>Adds nodes: those of a chunk, or of upper levels.</summary>
    public void Include(int minSideLog2, IReadOnlyList<long> bytesOfPlane)
    {
        MinSideLog2 = Math.Min(MinSideLog2, minSideLog2);
        for (int p = 0; p < BytesOfPlane.Length; p++)
            BytesOfPlane[p] += bytesOfPlane[p];
    }

    public void Write(BinaryWriter to)
    {
        to.Write(Statistics.Count);
        to.Write(Statistics.LeftOut);
        PartBytes.Write(to, Statistics.Min);
        PartBytes.Write(to, Statistics.Max);
        to.Write(Statistics.Checksum);
        to.Write(Statistics.MaxRoundingSteps);
        to.Write(OwnBlockPoints);
        to.Write(OutsidePoints);
        to.Write(Checksum);
        to.Write(MinSideLog2);
        to.Write(Attributes.Length);
        to.Write(BytesOfPlane.Length);
        foreach (var attribute in Attributes)
        {
            to.Write(attribute.OrderedMin);
            to.Write(attribute.OrderedMax);
            to.Write(attribute.Or);
            to.Write(attribute.Modulo257OrOfUInt16);
        }
        foreach (long bytes in BytesOfPlane)
            to.Write(bytes);
    }

    public static PartResult Read(BinaryReader from)
    {
        var statistics = new PointStatistics
        {
            Count = from.ReadInt64(),
            LeftOut = from.ReadInt64(),
            Min = PartBytes.ReadGrid3(from),
            Max = PartBytes.ReadGrid3(from),
            Checksum = from.ReadUInt64(),
            MaxRoundingSteps = from.ReadDouble(),
        };
        var (wanted, outside, checksum, lowest) =
            (from.ReadInt64(), from.ReadInt64(), from.ReadUInt64(), from.ReadInt32());
        var result = new PartResult(PartBytes.ReadCount(from), PartBytes.ReadCount(from))
        {
            Statistics = statistics,
            OwnBlockPoints = wanted,
            OutsidePoints = outside,
            Checksum = checksum,
            MinSideLog2 = lowest,
        };
        for (int a = 0; a < result.Attributes.Length; a++)
            result.Attributes[a] = new AttributeStatistics
            {
                OrderedMin = from.ReadUInt64(),
                OrderedMax = from.ReadUInt64(),
                Or = from.ReadUInt64(),
                Modulo257OrOfUInt16 = from.ReadUInt32(),
            };
        for (int p = 0; p < result.BytesOfPlane.Length; p++)
            result.BytesOfPlane[p] = from.ReadInt64();
        return result;
    }
}

static class PartBytes
{
    public static byte[] Of(Action<BinaryWriter> write)
    {
        using var bytes = new MemoryStream();
        using (var writer = new BinaryWriter(bytes))
            write(writer);
        return bytes.ToArray();
    }

    public static void Read(string path, long offset, byte[] bytes, Action<BinaryReader> read)
    {
        using var reader = new BinaryReader(new MemoryStream(bytes));
        try
        {
            read(reader);
        }
        catch (EndOfStreamException e)
        {
            throw new PointCloudException(FailureCode.BadInput, path, offset + bytes.Length,
                "wanted more than these " + bytes.Length + " bytes", e);
        }
        if (reader.BaseStream.Position != bytes.Length)
            throw PointCloudException.Wanted(FailureCode.BadInput, path, offset, "bytes", reader.BaseStream.Position,
                bytes.Length);
    }

    public static void Write(BinaryWriter to, GridCube cube)
    {
        Write(to, cube.Corner);
        to.Write(cube.SideLog2);
    }

    public static GridCube ReadCube(BinaryReader from) => new GridCube(ReadGrid3(from), from.ReadInt32());

    public static void Write(BinaryWriter to, Grid3 position)
    {
        to.Write(position.X);
        to.Write(position.Y);
        to.Write(position.Z);
    }

    public static Grid3 ReadGrid3(BinaryReader from) =>
        new Grid3(from.ReadInt64(), from.ReadInt64(), from.ReadInt64());

    /// <summary>A number of elements that follow, of a byte at least.</summary>
    public static int ReadCount(BinaryReader from)
    {
        int count = from.ReadInt32();
        if (count < 0 || count > from.BaseStream.Length - from.BaseStream.Position)
            throw new EndOfStreamException();
        return count;
    }
}
