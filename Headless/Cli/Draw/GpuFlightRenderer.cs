using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace FastPoints.Cli.Draw;

/// <summary>Pictures of all clouds that are streamed, drawn by the package's own renderer on a GPU, or on a
/// software one. Main thread; waits for the GPU.</summary>
public sealed class GpuFlightRenderer : FlightRenderer
{
    readonly StreamContext m_stream;
    readonly PointMaterials m_materials;
    readonly PointRenderer m_renderer;
    readonly SizeTree m_sizes = new();
    readonly RenderTexture m_target;
    readonly CommandBuffer m_commands = new() { name = "FastPoints" };
    float m_edlStrength;

    /// <param name="canCompute">Draws one-pixel points with a compute shader instead of point primitives.</param>
    public GpuFlightRenderer(GpuShaders shaders, StreamContext stream, PictureOptions options, bool canCompute = true)
        : base(options)
    {
        m_stream = stream;
        m_materials = new PointMaterials(shaders.Points, shaders.Compose, canCompute ? shaders.Raster : null,
            shaders.Progressive);
        m_renderer = new PointRenderer(m_materials, (GraphicsNodePool)stream.Pool, m_sizes);
        m_target = new RenderTexture(options.WidthPx, options.HeightPx, GraphicsFormat.R8G8B8A8_UNorm, GraphicsFormat.D32_SFloat);
        m_target.Create();
    }

    public int PointsPerFrame { get; set; }

    internal override void Add(int cloud, PicturePlan plan)
    {
        m_edlStrength = Math.Max(m_edlStrength, plan.EdlStrength);
        base.Add(cloud, plan);
        var look = CloudLooks.Of(plan.Colors, m_stream.Clouds[cloud].Source, plan.HiddenClasses);
        look.Light = plan.LitLevel / (float)PointLighting.MaxLitLevel;
        m_renderer.List.SetLook(cloud, look);
    }

    public override RgbaImage Draw(in Camera camera)
    {
        int width = Options.WidthPx, height = Options.HeightPx;
        var view = RenderViews.Of(camera, width, height, camera.IsOrthographic ? MaxCloudDepth(camera) : 0);
        view.Style = StyleOf(Options, m_edlStrength);
        view.Style.PointsPerFrame = PointsPerFrame;
        view.Light = Plan?.Light.RelativeTo(camera.EyeGeo) ?? default;
        view.Color = m_target;
        view.Depth = m_target;
        m_renderer.Prepare(m_stream, camera.ToStreamView(width, height), view.Style);
        m_commands.Clear();
        m_commands.SetRenderTarget(m_target);
        m_commands.ClearRenderTarget(true, true, ColorOf(Options.Background));
        m_renderer.Record(m_commands, view);
        Graphics.ExecuteCommandBuffer(m_commands);
        var request = AsyncGPUReadback.Request(m_target);
        request.WaitForCompletion();
        if (request.hasError)
            throw new InvalidOperationException("the picture could not be read back from " + SystemInfo.graphicsDeviceName);
        var image = new RgbaImage(width, height);
        request.GetData<byte>().CopyTo(image.Rgba);
        return image;
    }

    public override void EndFrame() => HeadlessGraphics.EndFrame();

    public override void Dispose()
    {
        HeadlessGraphics.WaitForIdle();
        m_renderer.Dispose();
        m_sizes.Dispose();
        m_materials.Dispose();
        m_commands.Dispose();
        m_target.Release();
    }

    static PointStyle StyleOf(PictureOptions options, float edlStrength)
    {
        var size = options.SizeInWorld
            ?? (options.PointSizePx >= 1 ? PointSize.Pixels(options.PointSizePx) : PointSize.Adaptive());
        return new PointStyle
        {
            Shape = size.LimitsPx.y <= 1 ? PointShape.Pixel
                : options.ParaboloidPoints ? PointShape.Paraboloid
                : options.BlendedPoints ? PointShape.Splat
                : options.RoundPoints ? PointShape.Disc
                : PointShape.Square,
            Size = size,
            EdlStrength = edlStrength,
            FillsHoles = options.FillsHoles,
            Shadows = options.Shadows,
        };
    }

    double MaxCloudDepth(in Camera camera)
    {
        double depth = 0;
        foreach (var cloud in m_stream.Clouds)
        {
            if (cloud == null)
                continue;
            var root = cloud.Source.Root.Side * cloud.Source.Grid.Step;
            for (int corner = 0; corner < 8; corner++)
            {
                var local = new double3(corner & 1, corner >> 1 & 1, corner >> 2) * root;
                var world = math.mul(cloud.Placement.Linear, local) + cloud.Placement.OriginWorld;
                depth = Math.Max(depth, Math.Abs(camera.ToView(world).z));
            }
        }
        return depth;
    }

    static Color ColorOf(uint rgba) => new((rgba & 0xFF) / 255f, (rgba >> 8 & 0xFF) / 255f, (rgba >> 16 & 0xFF) / 255f,
        (rgba >> 24) / 255f);
}
