namespace FastPoints.Cli.Demo;

/// <summary>Returns of a scan as binary little-endian PLY: double coordinates, since floats would not hold them.</summary>
internal sealed class PlyOutput : IReturnSink
{
    const int RecordBytes = 3 * 8 + 3 + 2 + 1;

    readonly Stream m_stream;
    readonly byte[] m_buffer = new byte[RecordBytes * 4096];
    readonly PositionTransform m_transform = TerrestrialScan.Transform;
    int m_end;

    public PlyOutput(Stream stream, long points)
    {
        m_stream = stream;
        stream.Write(Encoding.ASCII.GetBytes(
            "ply\nformat binary_little_endian 1.0\n"
            + "comment seeded terrestrial laser scan, WGS 84 / UTM zone 32N\n"
            + "element vertex " + points.ToString(CultureInfo.InvariantCulture) + "\n"
            + "property double x\nproperty double y\nproperty double z\n"
            + "property uchar red\nproperty uchar green\nproperty uchar blue\n"
            + "property ushort intensity\nproperty uchar classification\nend_header\n"));
    }

    public void Append(NativeArray<ScanReturn> returns)
    {
        for (int i = 0; i < returns.Length; i++)
            Append(returns[i]);
    }

    public void Append(NativeArray<ScanReturn> returns, NativeArray<int> returnNumber)
    {
        for (int i = 0; i < returnNumber.Length; i++)
            Append(returns[returnNumber[i]]);
    }

    void Append(in ScanReturn r)
    {
        var geo = m_transform.ToGeo(new double3(r.X, r.Y, r.Z));
        var record = m_buffer.AsSpan(m_end, RecordBytes);
        BinaryPrimitives.WriteDoubleLittleEndian(record, geo.x);
        BinaryPrimitives.WriteDoubleLittleEndian(record[8..], geo.y);
        BinaryPrimitives.WriteDoubleLittleEndian(record[16..], geo.z);
        record[24] = (byte)(r.Red >> 8);
        record[25] = (byte)(r.Green >> 8);
        record[26] = (byte)(r.Blue >> 8);
        BinaryPrimitives.WriteUInt16LittleEndian(record[27..], r.Intensity);
        record[29] = r.Classification;
        m_end += RecordBytes;
        if (m_end == m_buffer.Length)
            Flush();
    }

    public void Flush()
    {
        m_stream.Write(m_buffer, 0, m_end);
        m_end = 0;
    }
}
