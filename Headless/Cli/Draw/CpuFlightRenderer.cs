namespace FastPoints.Cli.Draw;

public sealed class CpuFlightRenderer(StreamContext stream, PictureOptions options) : FlightRenderer(options)
{
    readonly StreamedPicture m_picture = new(options);

    internal override void Add(int cloud, PicturePlan plan) => m_picture.Add(new StreamedBlocks(stream, cloud, plan), plan.Mode);
    public override RgbaImage Draw(in Camera camera) => m_picture.Draw(camera);
    public override void Dispose() => m_picture.Dispose();
}
