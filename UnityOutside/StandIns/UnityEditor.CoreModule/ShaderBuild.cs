using UnityEditor.Rendering;

namespace UnityEditor.Rendering
{
    public struct ShaderSnippetData
    {
        public string passName { get; internal set; }
    }

    public struct ShaderCompilerData { }
}

namespace UnityEditor.Build
{
    public interface IPreprocessShaders : IOrderedCallback
    {
        void OnProcessShader(UnityEngine.Shader shader, ShaderSnippetData snippet, IList<ShaderCompilerData> data);
    }

    public interface IPreprocessComputeShaders : IOrderedCallback
    {
        void OnProcessComputeShader(UnityEngine.ComputeShader shader, string kernelName, IList<ShaderCompilerData> data);
    }
}
