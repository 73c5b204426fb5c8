namespace FastPoints.Cli.Draw;

/// <summary>Draws what a stream's last frame listed.</summary>
public abstract class FlightPicture(PictureOptions options) : IDisposable
{
    public PictureOptions Options => options;

    /// <summary>One more of the stream's clouds.</summary>
    internal abstract void Add(int cloud, PicturePlan plan);

    public abstract RgbaImage Draw(in Camera camera);

    /// <summary>Once a frame, drawn or not.</summary>
    public virtual void EndFrame() { }

    public abstract void Dispose();
}
