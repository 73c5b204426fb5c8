using StandIns.Graphics;
using UnityEditor.Rendering;
using UnityEngine.Rendering;

namespace UnityEditor.Rendering
{
    public struct ShaderSnippetData
    {
        public string passName { get; internal set; }
    }

    public struct ShaderCompilerData
    {
        public ShaderKeywordSet shaderKeywordSet;
    }
}

namespace UnityEditor.Build
{
    public interface IPreprocessShaders : IOrderedCallback
    {
        void OnProcessShader(Shader shader, ShaderSnippetData snippet, IList<ShaderCompilerData> data);
    }

    /// <summary>What a build of shaders would compile.</summary>
    static class ShaderBuild
    {
        /// <summary>All variants of a shader's passes, pass by pass, without what a callback takes out.</summary>
        internal static Dictionary<string, List<HashSet<string>>> Build(Shader shader, IPreprocessShaders callback)
        {
            var built = new Dictionary<string, List<HashSet<string>>>();
            foreach (var pass in shader.Source.Passes)
            {
                var data = new List<ShaderCompilerData>();
                for (long variant = 0; variant < KeywordVariant.Count(pass.Keywords); variant++)
                    data.Add(new ShaderCompilerData
                    {
                        shaderKeywordSet = new ShaderKeywordSet
                        {
                            Names = KeywordVariant.Names(pass.Keywords, variant, "vert").ToHashSet(),
                        },
                    });
                callback.OnProcessShader(shader, new ShaderSnippetData { passName = pass.Name }, data);
                built.Add(pass.Name, data.Select(d => d.shaderKeywordSet.Names).ToList());
            }
            return built;
        }
    }
}
