namespace FastPoints.Cli.Draw;

public sealed class CpuFlightRenderer(StreamContext stream, PictureOptions options) : FlightRenderer(options)
{
    readonly StreamedPicture m_picture = new(options);

    internal override void Add(int cloud, PicturePlan plan)
    {
        base.Add(cloud, plan);
        m_picture.Add(new StreamedBlocks(stream, cloud, plan), plan.Mode);
    }

    public override RgbaImage Draw(in Camera camera) => m_picture.Draw(camera);

    public override double MeasurePopping(in Camera camera, RgbaImage picture, bool isCut)
    {
        double popping = isCut ? double.NaN : FlipMap.Of(picture, m_picture.DrawKept(camera)).Mean;
        m_picture.Keep();
        return popping;
    }

    public override void Dispose() => m_picture.Dispose();
}
