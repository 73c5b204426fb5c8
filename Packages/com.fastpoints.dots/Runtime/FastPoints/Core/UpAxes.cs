using Unity.Mathematics;

namespace FastPoints
{
    internal static class UpAxes
    {
        // Index among X, Y and Z, ignoring the sign.
        public static int Index(this UpAxis axis) => (int)axis % 3;

        public static bool IsNegative(this UpAxis axis) => axis >= UpAxis.NegativeX;

        public static double Height(this UpAxis axis, double3 geo) => axis.IsNegative() ? -geo[axis.Index()] : geo[axis.Index()];

        // Unit vectors of the cloud's space that point east, north and up for people: right-handed, like its axes.
        public static void Directions(this UpAxis axis, out double3 east, out double3 north, out double3 up)
        {
            double3 x = new double3(1, 0, 0), y = new double3(0, 1, 0), z = new double3(0, 0, 1);
            (east, north, up) = (UpAxis)axis.Index() switch
            {
                UpAxis.X => (y, z, x),
                UpAxis.Y => (x, -z, y),
                _ => (x, y, z),
            };
            // Half a turn about the east.
            if (axis.IsNegative())
                (north, up) = (-north, -up);
        }
    }

    /// <summary>The axis of a cloud that points up.</summary>
    public enum UpAxis
    {
        X = 0,
        Y = 1,
        Z = 2,

        /// <summary>X points down.</summary>
        NegativeX = 3,

        /// <summary>Y points down, as in cameras' coordinates.</summary>
        NegativeY = 4,

        /// <summary>Z points down: depths.</summary>
        NegativeZ = 5,
    }
}
