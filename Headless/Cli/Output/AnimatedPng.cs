namespace FastPoints.Cli.Output;

/// <summary>
/// An animation in the PNG format (APNG 1.0): any viewer shows the first picture, browsers all of them. Pictures go to
/// the file as they come; the file is complete or absent.
/// </summary>
public sealed class AnimatedPng : IDisposable
{
    readonly string m_path;
    readonly int m_widthPx;
    readonly int m_heightPx;
    readonly int m_pictures;
    readonly ushort m_delayMs;
    FileStream? m_file;
    int m_count;
    uint m_sequence;

    /// <param name="pictures">So many must be added.</param>
    /// <param name="delayMs">Each is shown for so long; the whole is repeated.</param>
    public AnimatedPng(string path, int widthPx, int heightPx, int pictures, int delayMs)
    {
        m_path = path;
        m_widthPx = widthPx;
        m_heightPx = heightPx;
        m_pictures = pictures;
        m_delayMs = checked((ushort)delayMs);
        Writing(() =>
        {
            m_file = new FileStream(path + ".partial", FileMode.Create, FileAccess.Write);
            Png.WriteHeader(m_file, widthPx, heightPx, true);
            // Frames, and how often to play them: 0 is for ever.
            var control = new byte[8];
            Png.WriteBig(control, 0, (uint)pictures);
            Png.WriteChunk(m_file, "acTL", control);
        });
    }

    /// <summary>The next picture; transparency is left out. The last one completes the file.</summary>
    public void Add(RgbaImage image)
    {
        if (image.Width != m_widthPx || image.Height != m_heightPx || m_count >= m_pictures)
            throw new ArgumentException("wanted " + m_pictures + " pictures of " + m_widthPx + "x" + m_heightPx +
                ", got one more, or of " + image.Width + "x" + image.Height, nameof(image));
        Writing(() => Write(image));
    }

    /// <summary>A file that is not complete is deleted.</summary>
    public void Dispose()
    {
        if (m_file == null)
            return;
        m_file.Dispose();
        m_file = null;
        File.Delete(m_path + ".partial");
    }

    void Write(RgbaImage image)
    {
        var control = new byte[26];
        Png.WriteBig(control, 0, m_sequence++);
        Png.WriteBig(control, 4, (uint)m_widthPx);
        Png.WriteBig(control, 8, (uint)m_heightPx);
        control[20] = (byte)(m_delayMs >> 8);
        control[21] = (byte)m_delayMs;
        control[22] = 1000 >> 8;
        control[23] = 1000 & 255;
        Png.WriteChunk(m_file, "fcTL", control);
        byte[] pixels = Png.CompressOpaque(image);
        if (m_count == 0)
        {
            Png.WriteChunk(m_file, "IDAT", pixels);
        }
        else
        {
            var data = new byte[pixels.Length + 4];
            Png.WriteBig(data, 0, m_sequence++);
            Array.Copy(pixels, 0, data, 4, pixels.Length);
            Png.WriteChunk(m_file, "fdAT", data);
        }
        if (++m_count < m_pictures)
            return;
        Png.WriteChunk(m_file, "IEND", Array.Empty<byte>());
        m_file!.Dispose();
        m_file = null;
        if (File.Exists(m_path))
            File.Delete(m_path);
        File.Move(m_path + ".partial", m_path);
    }

    void Writing(Action write)
    {
        try
        {
            write();
        }
        catch (Exception e) when (e is IOException || e is UnauthorizedAccessException)
        {
            throw new PointCloudException(e is UnauthorizedAccessException ? FailureCode.AccessDenied
                : FailureCode.WriteFailed, m_path, -1, "the animation cannot be written: " + e.Message, e);
        }
    }
}
