namespace FastPoints.Cli.Surfaces;

/// <summary>Triangles as binary PLY with doubles, or as OBJ; corners counter-clockwise from outside.</summary>
static class SurfaceFile
{
    public static bool CanWrite(string path) => IsPly(path) || path.EndsWith(".obj", StringComparison.OrdinalIgnoreCase);

    static bool IsPly(string path) => path.EndsWith(".ply", StringComparison.OrdinalIgnoreCase);

    /// <param name="stepOfCoordinates">Digits below it are not written as text.</param>
    public static void Write(string path, IReadOnlyList<double3> vertices, List<int3> triangles, double stepOfCoordinates,
        CancellationToken cancellation)
    {
        using var file = new OutputFile(path);
        try
        {
            if (IsPly(path))
                WritePly(file.Stream, vertices, triangles, cancellation);
            else
                WriteObj(file.Stream, vertices, triangles, stepOfCoordinates, cancellation);
        }
        catch (IOException e)
        {
            throw FileFailures.WriteFailure(path, e);
        }
        file.Commit();
    }

    static void WritePly(Stream stream, IReadOnlyList<double3> vertices, List<int3> triangles, CancellationToken cancellation)
    {
        using var writer = new BinaryWriter(stream, Encoding.ASCII, leaveOpen: true);
        writer.Write(Encoding.ASCII.GetBytes("ply\nformat binary_little_endian 1.0\ncomment written by FastPoints\n"
            + "element vertex " + vertices.Count + "\nproperty double x\nproperty double y\nproperty double z\n"
            + "element face " + triangles.Count
            + "\nproperty list uchar int vertex_indices\nend_header\n"));
        foreach (var vertex in vertices)
        {
            cancellation.ThrowIfCancellationRequested();
            writer.Write(vertex.x);
            writer.Write(vertex.y);
            writer.Write(vertex.z);
        }
        foreach (var triangle in triangles)
        {
            cancellation.ThrowIfCancellationRequested();
            writer.Write((byte)3);
            writer.Write(triangle.x);
            writer.Write(triangle.y);
            writer.Write(triangle.z);
        }
    }

    static void WriteObj(Stream stream, IReadOnlyList<double3> vertices, List<int3> triangles, double step,
        CancellationToken cancellation)
    {
        using var writer = new StreamWriter(stream, new UTF8Encoding(false), 1 << 16, leaveOpen: true);
        string form = "F" + Math.Clamp((int)Math.Ceiling(-Math.Log10(step)), 0, 15);
        string Text(double value) => value.ToString(form, CultureInfo.InvariantCulture);
        writer.Write("# written by FastPoints\n");
        foreach (var vertex in vertices)
        {
            cancellation.ThrowIfCancellationRequested();
            writer.Write("v " + Text(vertex.x) + " " + Text(vertex.y) + " " + Text(vertex.z) + "\n");
        }
        foreach (var triangle in triangles)
        {
            cancellation.ThrowIfCancellationRequested();
            writer.Write("f " + (triangle.x + 1) + " " + (triangle.y + 1) + " " + (triangle.z + 1) + "\n");
        }
    }
}
