namespace FastPoints.Cli.Draw;

public abstract class FlightRenderer(PictureOptions options) : IDisposable
{
    public PictureOptions Options => options;

    internal abstract void Add(int cloud, PicturePlan plan);

    public abstract RgbaImage Draw(in Camera camera);

    public virtual void EndFrame() { }

    public abstract void Dispose();
}
