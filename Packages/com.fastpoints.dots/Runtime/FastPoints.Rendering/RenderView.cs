using UnityEngine;
using UnityEngine.Rendering;

namespace FastPoints.Rendering
{
    /// <summary>One camera, or one eye of a headset, as drawing sees it.</summary>
    public struct RenderView
    {
        /// <summary>From places relative to the eye, along the world's axes, to the clip space of the graphics API (<see
        /// cref="GL.GetGPUProjectionMatrix(Matrix4x4, bool)"/>): the eye's own place is not in it.</summary>
        public Matrix4x4 ViewProjection;

        /// <summary>From the place that the draws were listed for, along the world's axes: of the right eye from the left
        /// one.</summary>
        public Vector3 EyeOffset;
        public int WidthPx;
        public int HeightPx;

        /// <summary>Where the camera looks: a unit vector of the world.</summary>
        public Vector3 Forward;

        /// <summary>Pixels of one unit: at a distance of one unit (perspective), or anywhere (orthographic).</summary>
        public float ScalePx;
        public bool IsOrthographic;

        /// <summary>Colours are written as light (a project in linear colour space), and not as sRGB.</summary>
        public bool IsLinear;

        /// <summary>What is drawn into. It is set already; a style that needs a layer of its own sets it again, the viewport
        /// being the whole picture.</summary>
        public RenderTargetIdentifier Color;
        public RenderTargetIdentifier Depth;
        internal TargetEye Eye;
        public PointStyle Style;
    }

    /// <summary>Which slice of a target is drawn into.</summary>
    internal enum TargetEye
    {
        /// <summary>The target as it is.</summary>
        Whole,

        /// <summary>The first slice of two.</summary>
        Left,

        /// <summary>The second one.</summary>
        Right,
    }
}
