using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace FastPoints.Gpu
{
    /// <summary>Edge of a point's square, diameter of its disc. Blittable, for jobs.</summary>
    public struct PointSize
    {
        public PointSizeMode Mode;

        /// <summary>Pixels; world units; or, adaptive, of the distance between points.</summary>
        public float Value;

        /// <summary>No point is smaller or larger, in pixels.</summary>
        public float MinPx;
        public float MaxPx;

        /// <summary>Adaptive: squares of this many gaps leave few pixels open. See
        /// Documentation~/error-against-time.md.</summary>
        public const float DefaultGaps = 1.5f;

        /// <summary>What a point takes at most where nothing else is said, but for sizes in pixels.</summary>
        public const float DefaultMaxPx = 32;

        public static PointSize Pixels(float px) =>
            new PointSize { Mode = PointSizeMode.Pixels, Value = px, MinPx = px, MaxPx = px };

        public static PointSize World(float length) =>
            new PointSize { Mode = PointSizeMode.World, Value = length, MinPx = 1, MaxPx = DefaultMaxPx };

        public static PointSize Adaptive(float gaps = DefaultGaps) =>
            new PointSize { Mode = PointSizeMode.Adaptive, Value = gaps, MinPx = 1, MaxPx = DefaultMaxPx };

        /// <summary>The same for all points of a picture, whatever their distance.</summary>
        public readonly bool IsConstant => Mode == PointSizeMode.Pixels;

        /// <summary>Least and most pixels, with what is wrong about them put right.</summary>
        public readonly float2 LimitsPx => new float2(math.max(1, MinPx), math.max(math.max(1, MinPx), MaxPx));

        /// <summary>The size in pixels.</summary>
        /// <param name="gap">Between points at that place, world units: looked at where the size is adaptive.</param>
        /// <param name="pixelsPerUnit">Of a world unit at the point's depth.</param>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public readonly float ToPx(float gap, float pixelsPerUnit)
        {
            float px = Mode == PointSizeMode.Pixels ? Value
                : Mode == PointSizeMode.World ? Value * pixelsPerUnit
                : Value * gap * pixelsPerUnit;
            return math.clamp(px, LimitsPx.x, LimitsPx.y);
        }
    }

    /// <summary>How large points are drawn.</summary>
    public enum PointSizeMode
    {
        /// <summary>So many pixels, near and far.</summary>
        Pixels,

        /// <summary>A length in the world: smaller farther away.</summary>
        World,

        /// <summary>As far apart as points are at that place, of all that is drawn there: surfaces close, detail stays.</summary>
        Adaptive,
    }
}
