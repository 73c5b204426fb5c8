namespace FastPoints.HostTests.Gpu;

/// <summary>HDRP: custom passes of all cameras.</summary>
sealed class HdrpHost : PipelineHost
{
    static readonly CustomPassInjectionPoint[] s_points =
    {
        CustomPassInjectionPoint.AfterOpaqueAndSky,
        CustomPassInjectionPoint.BeforePreRefraction,
        CustomPassInjectionPoint.BeforeTransparent,
    };

    public Vector2 Jitter { get; set; }

    /// <summary>What HDRP draws before the injection point over what no opaque mesh covers, as its depth pyramid knows: fog
    /// before BeforePreRefraction, volumetric clouds and water before BeforeTransparent. None without a colour.</summary>
    public (CustomPassInjectionPoint Before, Color Color)? Cover { get; set; }

    public HdrpHost()
    {
        HdrpPass.Begin();
        HdrpPass.Begin();
    }

    public override void Render(Camera camera)
    {
        using var commands = new CommandBuffer();
        Clear(camera, commands);
        var target = new RTHandle { Texture = camera.targetTexture };
        var jittered = camera.projectionMatrix;
        jittered.m02 += Jitter.x;
        jittered.m12 += Jitter.y;
        var view = camera.worldToCameraMatrix;
        view.SetColumn(3, new Vector4(0, 0, 0, 1));
        var constants = new HDCamera.ViewConstants
        {
            viewMatrix = view,
            projMatrix = GL.GetGPUProjectionMatrix(jittered, true),
            worldSpaceCameraPos = camera.transform.position,
        };
        foreach (var point in s_points)
        {
            if (Cover is { } cover && cover.Before == point)
            {
                commands.SetRenderTarget(camera.targetTexture, 0, CubemapFace.Unknown, -1);
                commands.ClearRenderTarget(false, true, cover.Color);
            }
            foreach (var (at, pass) in CustomPassVolume.Global)
                if (at == point)
                    pass.Run(new CustomPassContext(commands, new HDCamera { camera = camera, mainViewConstants = constants },
                        target, target));
        }
        Graphics.ExecuteCommandBuffer(commands);
    }

    public override void Dispose() => HdrpPass.End();
}
