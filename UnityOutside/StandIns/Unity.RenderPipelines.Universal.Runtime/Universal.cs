using System.Collections.Generic;
using Unity.Collections;
using UnityEngine.Rendering.RenderGraphModule;

namespace UnityEngine.Rendering.Universal;

public class RenderGraphSettings : IRenderPipelineGraphicsSettings
{
    /// <summary>Where it is on, passes are not recorded.</summary>
    public bool enableRenderCompatibilityMode { get; internal set; }
}

public enum CameraRenderType { Base = 0, Overlay = 1 }

public enum RenderPassEvent { AfterRenderingOpaques = 300 }

public abstract class ScriptableRenderPass : IRenderGraphRecorder
{
    public RenderPassEvent renderPassEvent { get; set; }

    public virtual void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData) { }
}

/// <summary>Keeps what was enqueued until a camera has been drawn with it: a camera that cannot be culled leaves its passes
/// to the next one.</summary>
public abstract class ScriptableRenderer
{
    internal readonly List<ScriptableRenderPass> Passes = new List<ScriptableRenderPass>();

    public void EnqueuePass(ScriptableRenderPass pass) => Passes.Add(pass);
}

public class UniversalAdditionalCameraData : MonoBehaviour
{
    public CameraRenderType renderType { get; set; }
    public bool allowXRRendering { get; set; } = true;

    /// <summary>The pipeline's own, where the camera has none.</summary>
    public ScriptableRenderer scriptableRenderer =>
        (GraphicsSettings.currentRenderPipeline as UniversalRenderPipelineAsset)?.scriptableRenderer;
}

public abstract class UniversalResourceDataBase : ContextItem { }

public class UniversalResourceData : UniversalResourceDataBase
{
    public TextureHandle activeColorTexture { get; internal set; }
    public TextureHandle activeDepthTexture { get; internal set; }

    public override void Reset() { }
}

public class UniversalLightData : ContextItem
{
    /// <summary>In <see cref="visibleLights"/>; -1 for none.</summary>
    public int mainLightIndex = -1;

    /// <summary>0 where the pipeline's asset has them disabled.</summary>
    public int additionalLightsCount;
    public NativeArray<VisibleLight> visibleLights;

    public override void Reset() => (mainLightIndex, additionalLightsCount, visibleLights) = (-1, 0, default);
}

public sealed class UniversalRenderPipeline
{
    /// <summary>As URP 17 has it, for lights whose inner angle is not known.</summary>
    public static void InitializeLightConstants_Common(NativeArray<VisibleLight> lights, int lightIndex, out Vector4 lightPos,
        out Vector4 lightColor, out Vector4 lightAttenuation, out Vector4 lightSpotDir, out Vector4 lightOcclusionProbeChannel)
    {
        var light = lights[lightIndex];
        var back = -light.localToWorldMatrix.GetColumn(2);
        bool isDirectional = light.lightType == LightType.Directional;
        lightPos = isDirectional ? new Vector4(back.x, back.y, back.z, 0) : light.localToWorldMatrix.GetColumn(3);
        lightColor = light.finalColor;
        lightAttenuation = new Vector4(0, 1, 0, 1);
        lightSpotDir = new Vector4(0, 0, 1, 0);
        lightOcclusionProbeChannel = default;
        if (!isDirectional)
            (lightAttenuation.x, lightAttenuation.y) = (1 / Math.Max(0.0001f, light.range * light.range), 1 / 0.36f);
        if (light.lightType != LightType.Spot)
            return;
        double half = light.spotAngle * Math.PI / 360, inner = Math.Atan(Math.Tan(half) * 46 / 64);
        lightAttenuation.z = 1 / (float)Math.Max(0.001, Math.Cos(inner) - Math.Cos(half));
        lightAttenuation.w = -(float)Math.Cos(half) * lightAttenuation.z;
        lightSpotDir = back;
    }
}

public class UniversalCameraData : ContextItem
{
    public Camera camera;
    public RenderTextureDescriptor cameraTargetDescriptor;

    /// <summary>Whether a headset shows the picture.</summary>
    public bool xrRendering;

    internal int Eye;

    public Matrix4x4 GetViewMatrix(int viewIndex = 0) =>
        xrRendering ? camera.GetStereoViewMatrix((Camera.StereoscopicEye)(Eye + viewIndex)) : camera.worldToCameraMatrix;

    public Matrix4x4 GetProjectionMatrix(int viewIndex = 0) =>
        xrRendering ? camera.GetStereoProjectionMatrix((Camera.StereoscopicEye)(Eye + viewIndex)) : camera.projectionMatrix;

    public bool IsRenderTargetProjectionMatrixFlipped(RTHandle color, RTHandle depth = null) => true;
    public override void Reset() => camera = null;
}

public enum RendererType { Custom = 0, UniversalRenderer = 1, _2DRenderer = 2 }

public abstract class ScriptableRendererData : ScriptableObject { }

/// <summary>What makes assets takes an editor.</summary>
public class UniversalRenderPipelineAsset : RenderPipelineAsset
{
    public ScriptableRenderer scriptableRenderer { get; internal set; }

    public static UniversalRenderPipelineAsset Create(ScriptableRendererData rendererData = null) =>
        throw new System.NotSupportedException("assets take an editor");

    public ScriptableRendererData LoadBuiltinRendererData(RendererType type = RendererType.UniversalRenderer) =>
        throw new System.NotSupportedException("assets take an editor");
}
