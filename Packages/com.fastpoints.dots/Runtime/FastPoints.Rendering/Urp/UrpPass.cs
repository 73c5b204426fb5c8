using System;
using FastPoints.Drawing;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Rendering.RenderGraphModule;
using UnityEngine.Rendering.Universal;

namespace FastPoints.Rendering.Urp
{
    /// <summary>Draws the clouds in URP, after opaque meshes: enqueued for each camera when it begins, so that no renderer asset
    /// has to be changed.</summary>
    internal sealed class UrpPass : ScriptableRenderPass
    {
        static UrpPass s_pass;
        Camera m_camera; // The camera whose pass is enqueued but not yet recorded.

        /// <summary>Created once: a new delegate in every frame would be garbage.</summary>
        static readonly BaseRenderFunc<PassData, UnsafeGraphContext> s_draw = Draw;

        sealed class PassData
        {
            public PointScene Scene;
            public UniversalCameraData CameraData;
            public TextureHandle Color;
            public TextureHandle Depth;
            public PointLighting Light;
        }

        UrpPass() => renderPassEvent = RenderPassEvent.AfterRenderingOpaques;

        /// <summary>Works with domain reload off, too: adding twice adds once.</summary>
        [BeginsPass]
        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        public static void Begin()
        {
            RenderPipelineManager.beginCameraRendering -= Enqueue;
            RenderPipelineManager.beginCameraRendering += Enqueue;
        }

        public static void End() => RenderPipelineManager.beginCameraRendering -= Enqueue;

        public override void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData)
        {
            // A camera that cannot be culled would leave its pass to the renderer's next camera, which has one of its own.
            var cameraData = frameData.Get<UniversalCameraData>();
            if (PointScene.Current == null || !ReferenceEquals(cameraData.camera, m_camera))
            {
                // Or a script draws a camera within another's turn, as mirrors do, and that takes what is enqueued for the other:
                // from now on, passes are enqueued after such scripts. Each frame, new delegates would be garbage.
                if (m_camera != null)
                    Begin();
                return;
            }
            m_camera = null;
            var resources = frameData.Get<UniversalResourceData>();
            // The 2D renderer may have no depth: points would not hide one another, and Unity would throw.
            if (!resources.activeDepthTexture.IsValid() || !resources.activeColorTexture.IsValid())
                return;
            using var builder = renderGraph.AddUnsafePass<PassData>("FastPoints", out var data);
            data.Scene = PointScene.Current;
            data.CameraData = cameraData;
            data.Color = resources.activeColorTexture;
            data.Depth = resources.activeDepthTexture;
            if (data.Scene.IsLit)
                data.Light = LightOf(frameData.Get<UniversalLightData>(), cameraData.camera);
            builder.UseTexture(data.Color, AccessFlags.ReadWrite);
            builder.UseTexture(data.Depth, AccessFlags.ReadWrite);
            builder.AllowPassCulling(false);
            builder.SetRenderFunc(s_draw);
        }

        static PointLighting LightOf(UniversalLightData lights, Camera camera)
        {
            int main = lights.mainLightIndex;
            var light = SceneLights.Of(main < 0 ? (VisibleLight?)null : lights.visibleLights[main]);
            // None where the asset turns additional lights off.
            for (int i = 0; i < lights.visibleLights.Length && lights.additionalLightsCount > 0; i++)
            {
                if (i == main)
                    continue;
                UniversalRenderPipeline.InitializeLightConstants_Common(lights.visibleLights, i, out var place, out var color,
                    out var attenuation, out var axis, out _);
                SceneLights.Add(ref light, camera.transform.position, place, color, attenuation, axis);
            }
            return light;
        }

        static void Draw(PassData data, UnsafeGraphContext context)
        {
            var commands = CommandBufferHelpers.GetNativeCommandBuffer(context.cmd);
            var camera = data.CameraData;
            var size = camera.cameraTargetDescriptor;
            // Both eyes of a headset are drawn into two slices.
            bool hasBothEyes = camera.xrRendering && camera.camera.stereoEnabled && size.volumeDepth > 1;
            var target = CameraTarget.Of(camera.camera, data.Color, data.Depth, hasBothEyes);
            target.Light = data.Light;
            target.IsTexture = camera.IsRenderTargetProjectionMatrixFlipped(data.Color, data.Depth);
            // Render scale is in the descriptor, dynamic resolution is not.
            var scaled = camera.camera;
            target.WidthPx = (int)((long)size.width * scaled.scaledPixelWidth / Math.Max(1, scaled.pixelWidth));
            target.HeightPx = (int)((long)size.height * scaled.scaledPixelHeight / Math.Max(1, scaled.pixelHeight));
            if (camera.xrRendering)
            {
                // Where a headset's eyes are drawn in turn, Camera.stereoActiveEye does not say which one this is.
                target.Eye = EyeMatrices.Of(camera.GetViewMatrix(), camera.GetProjectionMatrix());
                if (hasBothEyes)
                    target.RightEye = EyeMatrices.Of(camera.GetViewMatrix(1), camera.GetProjectionMatrix(1));
            }
            else
            {
                target.Eye = EyeMatrices.OfMono(camera.camera);
            }
            // This includes the jitter of temporal anti-aliasing.
            target.Eye.Projection = camera.GetProjectionMatrix();
            data.Scene.Record(commands, camera.camera, target);
        }

#if !UNITY_6000_4_OR_NEWER
        static bool s_hasWarned;

#endif
        /// <summary>In Compatibility Mode passes are not recorded, and Unity would warn of each in each frame.</summary>
        static bool IsWithoutRenderGraph()
        {
#if UNITY_6000_4_OR_NEWER
            return false;
#else
            if (!GraphicsSettings.TryGetRenderPipelineSettings<RenderGraphSettings>(out var settings) ||
                !settings.enableRenderCompatibilityMode)
                return false;
            if (!s_hasWarned)
                Debug.LogWarning("Point clouds are not drawn in URP's Compatibility Mode (Project Settings > Graphics > URP)");
            s_hasWarned = true;
            return true;
#endif
        }

        static void Enqueue(ScriptableRenderContext context, Camera camera)
        {
            var scene = PointScene.Current;
            if (scene == null || !(GraphicsSettings.currentRenderPipeline is UniversalRenderPipelineAsset pipeline))
                return;
            if (IsWithoutRenderGraph())
                return;
            // The pipeline's own getter would add the component to cameras of the user's scene.
            bool hasData = camera.TryGetComponent<UniversalAdditionalCameraData>(out var cameraData);
            if (!PointScene.ShowsClouds(camera, hasData && cameraData.renderType == CameraRenderType.Overlay))
                return;
            // Into such a target URP draws only depth.
            if (camera.targetTexture != null && camera.targetTexture.graphicsFormat == GraphicsFormat.None)
                return;
            scene.AddView(camera, !hasData || cameraData.allowXRRendering);
            if (!scene.BeginPicture(camera))
                return;
            s_pass ??= new UrpPass();
            s_pass.m_camera = camera;
            // Without it, and in Scene views, URP draws by its asset's default renderer.
            var renderer = hasData && camera.cameraType != CameraType.SceneView ? cameraData.scriptableRenderer : null;
            (renderer ?? pipeline.scriptableRenderer)?.EnqueuePass(s_pass);
        }
    }
}
