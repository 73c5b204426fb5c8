using System.Collections.Generic;

namespace UnityEngine.Rendering.HighDefinition;

public enum CustomPassInjectionPoint
{
    BeforeTransparent = 1,
    BeforePreRefraction = 4,
    AfterOpaqueAndSky = 6,
}

public class HDCamera
{
    public struct ViewConstants
    {
        /// <summary>Without a translation: what is drawn is relative to the camera.</summary>
        public Matrix4x4 viewMatrix;

        /// <summary>The device's for a texture, jittered.</summary>
        public Matrix4x4 projMatrix;
        public Vector3 worldSpaceCameraPos;
    }

    public Camera camera;
    public ViewConstants mainViewConstants;

    public int actualWidth => camera.pixelWidth;
    public int actualHeight => camera.pixelHeight;
}

public class HDAdditionalCameraData : MonoBehaviour
{
    public bool xrRendering = true;
}

public struct CustomPassContext
{
    public readonly CommandBuffer cmd;
    public readonly HDCamera hdCamera;
    public readonly RTHandle cameraColorBuffer;
    public readonly RTHandle cameraDepthBuffer;

    internal CustomPassContext(CommandBuffer commands, HDCamera camera, RTHandle color, RTHandle depth) =>
        (cmd, hdCamera, cameraColorBuffer, cameraDepthBuffer) = (commands, camera, color, depth);
}

public abstract class CustomPass
{
    public string name { get; set; }

    protected virtual void Execute(CustomPassContext ctx) { }
    internal void Run(in CustomPassContext context) => Execute(context);
}

public class CustomPassVolume : MonoBehaviour
{
    internal static readonly List<(CustomPassInjectionPoint Point, CustomPass Pass)> Global =
        new List<(CustomPassInjectionPoint, CustomPass)>();

    public static void RegisterGlobalCustomPass(CustomPassInjectionPoint injectionPoint, CustomPass customPassInstance,
        float priority = 0) => Global.Add((injectionPoint, customPassInstance));

    public static bool UnregisterGlobalCustomPass(CustomPassInjectionPoint injectionPoint, CustomPass customPassInstance) =>
        Global.RemoveAll(p => p == (injectionPoint, customPassInstance)) > 0;
}

public class HDRenderPipelineAsset : RenderPipelineAsset { }
