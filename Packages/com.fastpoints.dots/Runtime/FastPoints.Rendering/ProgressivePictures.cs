using System;
using FastPoints.Drawing;
using UnityEngine;

namespace FastPoints.Rendering
{
    // Whether one camera's pictures are progressive, and what they take then: nothing as long as they are not.
    internal sealed class ProgressivePictures : IDisposable
    {
        const int BuffersPerVertex = 3;

        internal static bool HasWarned { get; set; }

        readonly ComputeShader m_shader;
        readonly bool m_canRun;
        readonly VisiblePoints[] m_visible = new VisiblePoints[1 + (int)TargetEye.Right];
        ComputeRaster m_raster;

        // shader: ProgressiveRaster.compute, or null.
        public ProgressivePictures(ComputeShader shader)
        {
            m_shader = shader;
            m_canRun = VisiblePoints.CanRun(shader) && SystemInfo.maxComputeBufferInputsVertex >= BuffersPerVertex;
        }

        public ComputeRaster Raster => m_raster ??= new ComputeRaster(m_shader);

        // Once a picture; whether it may be progressive.
        public bool Begin(in PointStyle style)
        {
            if (style.PointsPerFrame <= 0)
            {
                Dispose();
                return false;
            }
            if (m_canRun && style.IsProgressive)
                return true;
            if (!HasWarned)
                Debug.LogWarning("Point clouds are drawn whole in every frame, PointsPerFrame has no effect: " +
                    (m_canRun ? "splats need all points" : "compute shaders or buffers of vertex shaders are missing"));
            HasWarned = true;
            return false;
        }

        // A list of no more points than a frame may draw is drawn whole.
        public void SkipProgressIfItFits(ref PointStyle style, DrawList list)
        {
            if (!list.IsProgressive || list.Points <= style.PointsPerFrame)
                style.PointsPerFrame = 0;
        }

        public VisiblePoints PointsOf(TargetEye eye) => m_visible[(int)eye] ??= new VisiblePoints(m_shader);

        public void Dispose()
        {
            m_raster?.Dispose();
            m_raster = null;
            for (int eye = 0; eye < m_visible.Length; eye++)
            {
                m_visible[eye]?.Dispose();
                m_visible[eye] = null;
            }
        }
    }
}
