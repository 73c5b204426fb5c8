using FastPoints.Rendering.Urp;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.RenderGraphModule;
using UnityEngine.Rendering.Universal;

namespace FastPoints.HostTests.Gpu
{
    /// <summary>URP: passes are enqueued when a camera begins, and record themselves into a render graph.</summary>
    sealed class UrpHost : PipelineHost
    {
        readonly Renderer m_renderer = new Renderer();

        sealed class Renderer : ScriptableRenderer
        {
        }

        public UrpHost()
        {
            GraphicsSettings.currentRenderPipeline = new UniversalRenderPipelineAsset();
            UrpPass.Begin();
        }

        public override void Render(Camera camera)
        {
            if (camera.gameObject.GetComponent<UniversalAdditionalCameraData>() == null)
                camera.gameObject.AddComponent<UniversalAdditionalCameraData>().scriptableRenderer = m_renderer;
            m_renderer.Passes.Clear();
            RenderPipelineManager.Begin(camera);
            var graph = new RenderGraph();
            var target = RenderGraph.Import(new RTHandle { Texture = camera.targetTexture });
            using var frame = new ContextContainer();
            var resources = frame.GetOrCreate<UniversalResourceData>();
            resources.activeColorTexture = target;
            resources.activeDepthTexture = target;
            var cameraData = frame.GetOrCreate<UniversalCameraData>();
            cameraData.camera = camera;
            cameraData.cameraTargetDescriptor = camera.targetTexture.descriptor;
            foreach (var pass in m_renderer.Passes)
                pass.RecordRenderGraph(graph, frame);
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
}
