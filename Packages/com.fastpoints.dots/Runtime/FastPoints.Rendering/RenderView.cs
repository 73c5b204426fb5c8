using FastPoints.Drawing;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace FastPoints.Rendering
{
    /// <summary>One camera, or one eye of a headset, as drawing sees it.</summary>
    public struct RenderView
    {
        /// <summary>Maps positions relative to the eye, along the world's axes, to the clip space of the graphics API
        /// (<see cref="GL.GetGPUProjectionMatrix(Matrix4x4, bool)"/>). It does not contain the eye's own position.</summary>
        public Matrix4x4 ViewProjection;

        /// <summary>From the eye that draws were listed for, the left one, along the world's axes.</summary>
        public Vector3 EyeOffset;
        public int WidthPx;
        public int HeightPx;

        /// <summary>Where the camera looks: a unit vector of the world.</summary>
        public Vector3 Forward;

        /// <summary>Pixels of one unit: at a distance of one unit (perspective), or anywhere (orthographic).</summary>
        public float ScalePx;
        public bool IsOrthographic;

        /// <summary>Whether colours are written as linear light (a project in linear colour space) instead of sRGB.</summary>
        public bool IsLinear;

        /// <summary>The target, which is set when uploads are done.</summary>
        public RenderTargetIdentifier Color;
        public RenderTargetIdentifier Depth;
        internal TargetEye Eye;
        internal PointLighting Light; // Of points that are lit.
        internal bool IsSubViewport; // The lower left part of a target that is larger.
        internal bool MayBeScreen; // Rows of the screen run the other way from a texture's.
        public PointStyle Style;

        // Unprojects pixels of the layer: the inverse of what the projection does to x and y, to be scaled by the depth along
        // the view.
        internal readonly PixelPositions PixelPositions
        {
            get
            {
                float3 x = Row(0), y = Row(1), forward = new float3(Forward.x, Forward.y, Forward.z);
                float volume = math.dot(x, math.cross(y, forward));
                float3 right = math.cross(y, forward) / volume, up = math.cross(forward, x) / volume;
                float down = SystemInfo.graphicsUVStartsAtTop ? -1 : 1;
                return new PixelPositions
                {
                    First = right * (1f / WidthPx - 1 - ViewProjection.m03) +
                        up * (down * (1f / HeightPx - 1) - ViewProjection.m13),
                    StepX = right * (2f / WidthPx),
                    StepY = up * (down * 2 / HeightPx),
                    Forward = math.cross(x, y) / volume,
                    IsOrthographic = IsOrthographic,
                };
            }
        }

        readonly float3 Row(int row)
        {
            var values = ViewProjection.GetRow(row);
            return new float3(values.x, values.y, values.z);
        }

        // Unity's _ProjectionParams.x for a texture, and whether the shader is to compare its value with it.
        internal readonly Vector4 Flip => new Vector4(SystemInfo.graphicsUVStartsAtTop ? -1 : 1, MayBeScreen ? 1 : 0, 0, 0);
    }

    internal enum TargetEye
    {
        Whole,

        Left, // The slice of a texture array.

        Right,
    }
}
