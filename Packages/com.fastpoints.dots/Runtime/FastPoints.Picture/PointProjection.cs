using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace FastPoints.Picture
{
    // Maps stored coordinates to pixels in one step: view = X * stored.x + Y * stored.y + Z * stored.z + W, all in double, then
    // the division. The eye is subtracted in double as part of W, so that a camera 10 m away from points with UTM coordinates
    // sees them to 2 nm; the depth becomes a float only afterwards.
    internal struct PointProjection
    {
        public int WidthPx;
        public int HeightPx;
        public bool IsOrthographic;
        public double ScalePx; // Pixels of one unit: at a distance of one unit (perspective), or anywhere (orthographic).

        public double3 X;
        public double3 Y;
        public double3 Z;
        public double3 W;

        public PointProjection(in Camera camera, in PositionTransform transform, int widthPx, int heightPx)
        {
            WidthPx = widthPx;
            HeightPx = heightPx;
            IsOrthographic = camera.IsOrthographic;
            ScalePx = camera.IsOrthographic ? heightPx / camera.HeightGeo : heightPx * 0.5 / math.tan(camera.FovRadians / 2);
            X = new double3(camera.Right.x, camera.Up.x, camera.Forward.x) * transform.Scale.x;
            Y = new double3(camera.Right.y, camera.Up.y, camera.Forward.y) * transform.Scale.y;
            Z = new double3(camera.Right.z, camera.Up.z, camera.Forward.z) * transform.Scale.z;
            W = camera.ToView(transform.Offset);
        }

        // x to the right, y down, (0, 0) the top left corner of the top left pixel. False behind the camera and where
        // coordinates are not finite.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public readonly bool Project(double x, double y, double z, out double xPx, out double yPx, out float depth)
        {
            double right = X.x * x + Y.x * y + Z.x * z + W.x;
            double up = X.y * x + Y.y * y + Z.y * z + W.y;
            double forward = X.z * x + Y.z * y + Z.z * z + W.z;
            double scale = IsOrthographic ? ScalePx : ScalePx / forward;
            xPx = WidthPx * 0.5 + right * scale;
            yPx = HeightPx * 0.5 - up * scale;
            depth = (float)forward;
            return (IsOrthographic || forward > 0) & depth - depth == 0;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public readonly double PixelsPerUnitAt(float depth) => IsOrthographic ? ScalePx : ScalePx / depth;

        // Order as the floats do, for either sign: smaller means nearer.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static uint DepthToBits(float depth)
        {
            uint bits = math.asuint(depth);
            return (bits & 0x80000000u) != 0 ? ~bits : bits | 0x80000000u;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static float DepthFromBits(uint bits) => math.asfloat((bits & 0x80000000u) != 0 ? bits & 0x7FFFFFFFu : ~bits);
    }
}
