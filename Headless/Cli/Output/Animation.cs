namespace FastPoints.Cli.Output;

abstract class Animation(string path, int widthPx, int heightPx, int pictures) : IDisposable
{
    readonly OutputFile m_file = new(path);
    int m_count;

    public string Path => path;
    public long Bytes { get; private set; }
    protected int WidthPx => widthPx;
    protected int HeightPx => heightPx;
    protected int Pictures => pictures;
    protected Stream Stream => m_file.Stream;

    public void Add(RgbaImage image)
    {
        if (image.Width != widthPx || image.Height != heightPx || m_count >= pictures)
            throw new ArgumentException("wanted " + pictures + " pictures of " + widthPx + "x" + heightPx +
                ", got one more, or of " + image.Width + "x" + image.Height, nameof(image));
        OutputFile.WithFileErrors(path, () =>
        {
            Write(image, m_count);
            if (++m_count < pictures)
                return;
            End();
            Bytes = Stream.Length;
            m_file.Commit();
        });
    }

    public void Dispose() => m_file.Dispose();

    /// <param name="number">From 0.</param>
    protected abstract void Write(RgbaImage image, int number);

    protected abstract void End();
}
