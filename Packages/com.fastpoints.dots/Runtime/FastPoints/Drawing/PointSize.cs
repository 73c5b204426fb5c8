using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace FastPoints.Drawing
{
    /// <summary>Edge of a point's square or diameter of its disc. Blittable, for jobs.</summary>
    public struct PointSize
    {
        public PointSizeMode Mode;

        /// <summary>In pixels, in world units, or, if adaptive, as a multiple of the distance between points.</summary>
        public float Value;

        /// <summary>No point is smaller or larger than these, in pixels.</summary>
        public float MinPx;
        public float MaxPx;

        /// <summary>Adaptive: squares of this many gaps leave few pixels open (internals/streamed-pictures.md).</summary>
        public const float DefaultGaps = 1.5f;

        /// <summary>The largest size in pixels unless another is set; sizes in pixels have no limit.</summary>
        public const float DefaultMaxPx = 32;

        public static PointSize Pixels(float px) =>
            new PointSize { Mode = PointSizeMode.Pixels, Value = px, MinPx = px, MaxPx = px };

        public static PointSize World(float length) =>
            new PointSize { Mode = PointSizeMode.World, Value = length, MinPx = 1, MaxPx = DefaultMaxPx };

        public static PointSize Adaptive(float gaps = DefaultGaps) =>
            new PointSize { Mode = PointSizeMode.Adaptive, Value = gaps, MinPx = 1, MaxPx = DefaultMaxPx };

        /// <summary>Whether all points of a picture have the same size, whatever their distance.</summary>
        public readonly bool IsConstant => Mode == PointSizeMode.Pixels;

        /// <summary>The smallest and largest size in pixels, with invalid limits corrected.</summary>
        public readonly float2 LimitsPx => new float2(math.max(1, MinPx), math.max(math.max(1, MinPx), MaxPx));

        /// <summary>In pixels, by the gap between points (if adaptive) and the pixels of a world unit at their depth.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public readonly float ToPx(float gap, float pixelsPerUnit)
        {
            float px = Mode == PointSizeMode.Pixels ? Value
                : Mode == PointSizeMode.World ? Value * pixelsPerUnit : Value * gap * pixelsPerUnit;
            return math.clamp(px, LimitsPx.x, LimitsPx.y);
        }
    }

    /// <summary>How point sizes are measured.</summary>
    public enum PointSizeMode
    {
        /// <summary>In pixels, near and far.</summary>
        Pixels,

        /// <summary>As a length in the world: points farther away are smaller.</summary>
        World,

        /// <summary>By the distance between all points drawn at that place: surfaces close, detail stays.</summary>
        Adaptive,
    }
}
