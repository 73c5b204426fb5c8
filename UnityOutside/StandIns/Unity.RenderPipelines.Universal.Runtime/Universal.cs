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
    public NativeArray<VisibleLight> visibleLights;

    public override void Reset() => (mainLightIndex, visibleLights) = (-1, default);
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
