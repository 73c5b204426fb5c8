using UnityEngine.Rendering.RenderGraphModule;

namespace FastPoints.HostTests.Gpu;

/// <summary>URP: passes are enqueued when a camera begins, and record themselves into a render graph.</summary>
sealed class UrpHost : PipelineHost
{
    readonly Renderer m_renderer = new Renderer();
    public int Eye { get; set; }

    public bool IsWithoutDepth { get; set; } // As the 2D renderer may be.

    public VisibleLight? MainLight { get; set; }
    public VisibleLight Additional { get; set; }
    public bool HasAdditional { get; set; } = true;

    public int PassCount { get; private set; }

    sealed class Renderer : ScriptableRenderer { }

    public UrpHost()
    {
        GraphicsSettings.currentRenderPipeline = new UniversalRenderPipelineAsset { scriptableRenderer = m_renderer };
        UrpPass.Begin();
    }

    public override void Render(Camera camera)
    {
        RenderPipelineManager.Begin(camera);
        RenderSingle(camera);
    }

    public void RenderSingle(Camera camera)
    {
        var graph = new RenderGraph();
        using var frame = new ContextContainer();
        var resources = frame.GetOrCreate<UniversalResourceData>();
        // A pass has to say of each that it uses it.
        if (camera.targetTexture.graphicsFormat != GraphicsFormat.None)
            resources.activeColorTexture = RenderGraph.Import(new RTHandle { Texture = camera.targetTexture });
        if (!IsWithoutDepth)
            resources.activeDepthTexture = RenderGraph.Import(new RTHandle { Texture = camera.targetTexture });
        var cameraData = frame.GetOrCreate<UniversalCameraData>();
        cameraData.camera = camera;
        var description = camera.targetTexture.descriptor;
        (description.width, description.height) = (camera.pixelWidth, camera.pixelHeight);
        cameraData.cameraTargetDescriptor = description;
        cameraData.xrRendering = camera.stereoEnabled &&
            (!camera.TryGetComponent<UniversalAdditionalCameraData>(out var data) || data.allowXRRendering);
        cameraData.Eye = Eye;
        VisibleLight[] visible = MainLight != null ? [Additional, MainLight.Value] : [];
        using var lights = new NativeArray<VisibleLight>(visible, Allocator.Persistent);
        var lightData = frame.GetOrCreate<UniversalLightData>();
        (lightData.mainLightIndex, lightData.visibleLights) = (lights.Length - 1, lights);
        lightData.additionalLightsCount = HasAdditional ? lights.Length / 2 : 0;
        foreach (var pass in m_renderer.Passes)
            pass.RecordRenderGraph(graph, frame);
        m_renderer.Passes.Clear();
        PassCount = graph.PassCount;
        using var commands = new CommandBuffer();
        Clear(camera, commands);
        graph.Execute(commands);
        Graphics.ExecuteCommandBuffer(commands);
    }

    public override void Dispose()
    {
        UrpPass.End();
        GraphicsSettings.currentRenderPipeline = null;
    }
}
