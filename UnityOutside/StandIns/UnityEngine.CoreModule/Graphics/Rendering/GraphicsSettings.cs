namespace UnityEngine.Rendering;

public interface IRenderPipelineGraphicsSettings { }

public sealed class GraphicsSettings : Object
{
    internal static readonly Dictionary<Type, object> Settings = new Dictionary<Type, object>();

    public static bool TryGetRenderPipelineSettings<T>(out T settings) where T : class, IRenderPipelineGraphicsSettings
    {
        settings = Settings.TryGetValue(typeof(T), out object found) ? (T)found : null;
        return settings != null;
    }

    /// <summary>Scriptable pipelines set it.</summary>
    public static bool lightsUseLinearIntensity { get; set; }

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
