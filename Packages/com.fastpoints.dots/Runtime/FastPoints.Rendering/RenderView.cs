using UnityEngine;

namespace FastPoints.Rendering
{
    /// <summary>One camera as drawing sees it.</summary>
    public struct RenderView
    {
        /// <summary>From places relative to the camera, along the world's axes, to the clip space of the graphics API (<see
        /// cref="GL.GetGPUProjectionMatrix(Matrix4x4, bool)"/>): the camera's own place is not in it.</summary>
        public Matrix4x4 ViewProjection;
        public int WidthPx;
        public int HeightPx;
        public PointShape Shape;

        /// <summary>Edge of a square, diameter of a disc.</summary>
        public float SizePx;

        /// <summary>Colours are written as light (a project in linear colour space), and not as sRGB.</summary>
        public bool IsLinear;
    }
}
