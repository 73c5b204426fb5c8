using System;
using UnityEngine;

namespace FastPoints.Rendering
{
    /// <summary>A material for each shape: keywords are looked at when commands are executed, not when they are recorded, so that
    /// one material could not draw two shapes in a frame.</summary>
    public sealed class PointMaterials : IDisposable
    {
        readonly Material[] m_ofShape;

        /// <param name="shader">The package's Points.shader.</param>
        public PointMaterials(Shader shader)
        {
            m_ofShape = new Material[1 + (int)PointShape.Disc];
            for (int shape = 0; shape < m_ofShape.Length; shape++)
                m_ofShape[shape] = new Material(shader) { hideFlags = HideFlags.HideAndDontSave };
            this[PointShape.Square].EnableKeyword(ShaderNames.SquaresKeyword);
            this[PointShape.Disc].EnableKeyword(ShaderNames.DiscsKeyword);
        }

        public Material this[PointShape shape] => m_ofShape[(int)shape];

        public void Dispose()
        {
            for (int shape = 0; shape < m_ofShape.Length; shape++)
            {
                if (m_ofShape[shape] == null)
                    continue;
                if (Application.isPlaying)
                    UnityEngine.Object.Destroy(m_ofShape[shape]);
                else
                    UnityEngine.Object.DestroyImmediate(m_ofShape[shape]);
                m_ofShape[shape] = null;
            }
        }
    }
}
