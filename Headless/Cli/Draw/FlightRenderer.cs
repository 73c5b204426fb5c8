namespace FastPoints.Cli.Draw;

public abstract class FlightRenderer(PictureOptions options) : IDisposable
{
    public PictureOptions Options => options;

    internal PicturePlan? Plan { get; private set; } // Of the first cloud: light falls on all.

    internal virtual void Add(int cloud, PicturePlan plan) => Plan ??= plan;

    public abstract RgbaImage Draw(in Camera camera);

    public bool MeasuresPopping { get; init; }

    /// <summary>What the level of detail changes in a frame: FLIP between its picture and what the last frame drew, seen by this
    /// frame's camera. To be called in each frame; NaN at a cut, as the first frame is.</summary>
    public virtual double MeasurePopping(in Camera camera, RgbaImage picture, bool isCut) => double.NaN;

    public virtual void EndFrame() { }

    public abstract void Dispose();
}
