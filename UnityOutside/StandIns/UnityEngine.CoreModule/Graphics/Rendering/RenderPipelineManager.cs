namespace UnityEngine.Rendering;

public static class RenderPipelineManager
{
    public static event Action<ScriptableRenderContext, Camera> beginCameraRendering;

    internal static void Begin(Camera camera) => beginCameraRendering?.Invoke(default, camera);
}

public struct ScriptableRenderContext { }
