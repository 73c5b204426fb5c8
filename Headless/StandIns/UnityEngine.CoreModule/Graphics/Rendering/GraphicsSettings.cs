namespace UnityEngine.Rendering
{
    public sealed class GraphicsSettings : Object
    {
        /// <summary>Null in the Built-in pipeline; a test sets another.</summary>
        public static RenderPipelineAsset currentRenderPipeline { get; internal set; }
    }

    public abstract class RenderPipelineAsset : Object
    {
    }
}
