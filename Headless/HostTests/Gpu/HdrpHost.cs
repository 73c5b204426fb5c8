using FastPoints.Rendering.Hdrp;
using UnityEngine.Rendering.HighDefinition;

namespace FastPoints.HostTests.Gpu;

/// <summary>HDRP: custom passes of all cameras.</summary>
sealed class HdrpHost : PipelineHost
{
    /// <summary>Of temporal anti-aliasing.</summary>
    public Vector2 Jitter { get; set; }

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
        foreach (var pass in CustomPassVolume.Global)
            pass.Run(new CustomPassContext(commands, new HDCamera { camera = camera, mainViewConstants = constants }, target,
                target));
        Graphics.ExecuteCommandBuffer(commands);
    }

    public override void Dispose() => HdrpPass.End();
}
