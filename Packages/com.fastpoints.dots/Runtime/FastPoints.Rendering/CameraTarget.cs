using UnityEngine;
using UnityEngine.Rendering;

namespace FastPoints.Rendering
{
    /// <summary>What a pipeline's pass draws one camera's picture into, and from where.</summary>
    internal struct CameraTarget
    {
        /// <summary>It is set already, all slices of it where it has several; a style that needs a layer of its own sets it
        /// again, the viewport being the whole picture.</summary>
        public RenderTargetIdentifier Color;
        public RenderTargetIdentifier Depth;

        /// <summary>Whether it is a render texture, which some APIs have upside down.</summary>
        public bool IsTexture;

        /// <summary>Of the target, which a pipeline may make larger or smaller than the camera's picture.</summary>
        public int WidthPx;
        public int HeightPx;

        public EyeMatrices Eye;

        /// <summary>Both of a headset's eyes at once: <see cref="Eye"/> is the left one, in the target's first slice, and the
        /// right one is in its second.</summary>
        public bool HasBothEyes;
        public EyeMatrices RightEye;

        /// <summary>As the camera itself says.</summary>
        public static CameraTarget Of(Camera camera, RenderTargetIdentifier color, RenderTargetIdentifier depth,
            bool hasBothEyes = false) => new CameraTarget
            {
                Color = color,
                Depth = depth,
                IsTexture = true,
                WidthPx = camera.pixelWidth,
                HeightPx = camera.pixelHeight,
                Eye = hasBothEyes ? EyeMatrices.Of(camera, Camera.StereoscopicEye.Left) : EyeMatrices.Of(camera),
                HasBothEyes = hasBothEyes,
                RightEye = hasBothEyes ? EyeMatrices.Of(camera, Camera.StereoscopicEye.Right) : default,
            };
    }
}
