namespace FastPoints.Cli.Stability;

static class GpuStage
{
    const int MaxBytes = 256 << 20;

    /// <summary>Share of covered pixels that may differ: discs are cut out by pixels, see internals/rendering.md.</summary>
    const double MaxDifferent = 0.002;

    /// <summary>In 255ths: of entries of the palette that lie beside one another. Places on a lattice often lie at the border
    /// of two, which floats and doubles round to either side.</summary>
    const int MaxPerChannel = 4;

    /// <returns>Share of the covered pixels that differ.</returns>
    public static double Run(string target, PictureOptions from, List<string> problems)
    {
        var options = new PictureOptions
        {
            WidthPx = from.WidthPx,
            HeightPx = from.HeightPx,
            Camera = from.Camera,
            // By position: of points at one position a GPU shows the last, the software rasteriser the smallest colour.
            Color = ColorMode.Elevation,
            PointSizePx = 3,
            RoundPoints = true,
            EdlStrength = 0,
        };
        var shaders = new GpuShaders();
        using var memory = new StreamContext(new MemoryNodePool(MaxBytes));
        using var gpuStream = new StreamContext(shaders.CreatePool(MaxBytes, 8 << 20));
        using var software = new CpuFlightRenderer(memory, options);
        using var drawn = new GpuFlightRenderer(shaders, gpuStream, options);
        var wanted = Draw(target, memory, software, options, problems);
        var got = Draw(target, gpuStream, drawn, options, problems);
        double differ = ImageError.ShareThatDiffers(wanted, got, options.Background, out int covered, MaxPerChannel);
        // In a picture of a few pixels, one may be shifted.
        if (differ > MaxDifferent && differ * covered > 1.5)
            problems.Add("card: " + differ * covered + " of " + covered + " pixels are not the software rasteriser's");
        return differ;
    }

    static RgbaImage Draw(string target, StreamContext stream, FlightRenderer picture, PictureOptions options,
        List<string> problems)
    {
        var (plan, _, cloud) = FlightCloud.Add(target, stream, options, CancellationToken.None);
        picture.Add(cloud, plan);
        StreamStage.Settle(stream, plan.Camera.ToStreamView(options.WidthPx, options.HeightPx), problems, picture.EndFrame);
        return picture.Draw(plan.Camera);
    }
}
