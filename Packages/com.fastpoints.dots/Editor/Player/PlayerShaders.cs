using System.Collections.Generic;
using FastPoints.Rendering;
using UnityEditor.Build;
using UnityEditor.Rendering;
using UnityEngine;
using UnityEngine.Rendering;

namespace FastPoints.Editor
{
    /// <summary>Leaves the shaders of pictures over several frames out of players that draw none: those draw all points at once,
    /// as where compute shaders are missing.</summary>
    internal sealed class PlayerShaders : IPreprocessShaders, IPreprocessComputeShaders
    {
        public int callbackOrder => 0;

        public void OnProcessShader(Shader shader, ShaderSnippetData snippet, IList<ShaderCompilerData> data)
        {
            if (FastPointsSettings.instance.ProgressiveInPlayers || shader != PointCloudResources.Load().Points)
                return;
            var keyword = new LocalKeyword(shader, ShaderNames.ProgressiveKeyword);
            for (int i = data.Count - 1; i >= 0; i--)
                if (data[i].shaderKeywordSet.IsEnabled(keyword))
                    data.RemoveAt(i);
        }

        public void OnProcessComputeShader(ComputeShader shader, string kernelName, IList<ShaderCompilerData> data)
        {
            if (!FastPointsSettings.instance.ProgressiveInPlayers && shader == PointCloudResources.Load().Progressive)
                data.Clear();
        }
    }
}
