using System;
using FastPoints.Drawing;
using UnityEngine;
using UnityEngine.Rendering;

namespace FastPoints.Rendering
{
    /// <summary>Where a pipeline's pass draws one camera's picture, and from which viewpoint.</summary>
    public struct CameraTarget
    {
        /// <summary>Set after uploads, with all slices if there are several.</summary>
        public RenderTargetIdentifier Color;
        public RenderTargetIdentifier Depth;

        /// <summary>Whether it is a render texture; some APIs store these upside down.</summary>
        public bool IsTexture;
        internal PointLighting Light; // Where points are lit.
        internal bool MayBeScreen; // Only the engine knows, when it draws.
        internal bool IsSubViewport; // The lower left part of a target that is larger.

        /// <summary>Width of the picture; a pipeline may make it larger or smaller than the camera's.</summary>
        public int WidthPx;
        public int HeightPx;

        public EyeMatrices Eye;

        /// <summary>Eye is the left one, in the target's first slice; the right one is in the second.</summary>
        public bool HasBothEyes;
        public EyeMatrices RightEye;

        /// <summary>The target with the viewpoint that the camera itself reports.</summary>
        public static CameraTarget Of(Camera camera, RenderTargetIdentifier color, RenderTargetIdentifier depth,
            bool hasBothEyes = false) => new CameraTarget
            {
                Color = color,
                Depth = depth,
                IsTexture = true,
                WidthPx = camera.scaledPixelWidth,
                HeightPx = camera.scaledPixelHeight,
                Eye = hasBothEyes ? EyeMatrices.Of(camera, Camera.StereoscopicEye.Left) : EyeMatrices.Of(camera),
                HasBothEyes = hasBothEyes,
                RightEye = hasBothEyes ? EyeMatrices.Of(camera, Camera.StereoscopicEye.Right) : default,
            };
    }

    /// <summary>Marks a static method without parameters that begins to draw clouds in a pipeline; calling it again changes
    /// nothing. The editor calls it after loading scripts, and <c>End</c> beside it before they are reloaded. In players it is
    /// called through an attribute of Unity's that edit mode ignores.</summary>
    [AttributeUsage(AttributeTargets.Method)]
    internal sealed class BeginsPassAttribute : Attribute { }
}
