using FastPoints.Rendering.Hdrp;
using UnityEngine.Rendering.HighDefinition;

namespace FastPoints.HostTests.Gpu;

/// <summary>HDRP: custom passes of all cameras.</summary>
sealed class HdrpHost : PipelineHost
{
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
        foreach (var pass in CustomPassVolume.Global)
            pass.Run(new CustomPassContext(commands, new HDCamera { camera = camera }, target, target));
        Graphics.ExecuteCommandBuffer(commands);
    }

    public override void Dispose() => HdrpPass.End();
}
