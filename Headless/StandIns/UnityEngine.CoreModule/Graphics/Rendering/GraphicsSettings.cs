namespace UnityEngine.Rendering;

public sealed class GraphicsSettings : Object
{
    /// <summary>Null in the Built-in pipeline; a test sets another.</summary>
    public static RenderPipelineAsset currentRenderPipeline { get; internal set; }

    /// <summary>No level of quality names another.</summary>
    public static RenderPipelineAsset defaultRenderPipeline
    {
        get => currentRenderPipeline;
        set => currentRenderPipeline = value;
    }
}

public abstract class RenderPipelineAsset : ScriptableObject { }
