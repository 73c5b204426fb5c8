using System.Collections.Generic;
using FastPoints.Rendering;
using UnityEditor.Build;
using UnityEditor.Rendering;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>Leaves the shaders of pictures over several frames out of players that draw none: those draw all points at once,
    /// as where compute shaders are missing.</summary>
    internal sealed class PlayerShaderStripper : IPreprocessShaders, IPreprocessComputeShaders
    {
        const string ProgressivePass = "Progressive"; // Of Points.shader.

        public int callbackOrder => 0;

        public void OnProcessShader(Shader shader, ShaderSnippetData snippet, IList<ShaderCompilerData> data)
        {
            if (!FastPointsSettings.instance.ProgressiveInPlayers && snippet.passName == ProgressivePass &&
                shader == PointCloudResources.Load().Points)
                data.Clear();
        }

        public void OnProcessComputeShader(ComputeShader shader, string kernelName, IList<ShaderCompilerData> data)
        {
            if (!FastPointsSettings.instance.ProgressiveInPlayers && shader == PointCloudResources.Load().Progressive)
                data.Clear();
        }
    }
}
