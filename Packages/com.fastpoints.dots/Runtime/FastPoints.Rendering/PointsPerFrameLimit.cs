using FastPoints.Drawing;
using Unity.Mathematics;
using UnityEngine;

namespace FastPoints.Rendering
{
    // The points that a frame may draw: the style's, or as many as the GPU draws in the style's time, where the player measures
    // its frames.
    internal sealed class PointsPerFrameLimit
    {
        readonly FrameTiming[] m_timings = new FrameTiming[1];
        PointsPerFrameController m_controller;
        PointStyle m_style;
        ulong m_lastFrame;

        // Once a frame. listedPoints: what cameras would draw without a limit.
        public int Next(in PointStyle style, long listedPoints)
        {
            if (!style.IsProgressive || style.GpuFrameMs <= 0 || !FrameTimingManager.IsFeatureEnabled())
            {
                m_style = default;
                return style.PointsPerFrame;
            }
            if (style.PointsPerFrame != m_style.PointsPerFrame || style.GpuFrameMs != m_style.GpuFrameMs)
                m_controller = new PointsPerFrameController(style.PointsPerFrame);
            m_style = style;
            FrameTimingManager.CaptureFrameTimings();
            if (FrameTimingManager.GetLatestTimings(1, m_timings) == 0)
                return m_controller.Points;
            var timing = m_timings[0];
            // A time of 0 was not measured.
            if (timing.frameStartTimestamp != m_lastFrame && timing.gpuFrameTime > 0)
                m_controller.Add((float)timing.gpuFrameTime, style.GpuFrameMs, (int)math.min(listedPoints * 5 / 4, int.MaxValue));
            m_lastFrame = timing.frameStartTimestamp;
            return m_controller.Points;
        }
    }
}
