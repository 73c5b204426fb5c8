using Unity.Mathematics;

namespace FastPoints.Points
{
    /// <summary>Directions that follow from the axis that points up.</summary>
    internal static class UpAxes
    {
        /// <summary>Unit vectors of the cloud's space that point east, north and up for people: right-handed, like its
        /// axes.</summary>
        public static void Directions(this UpAxis axis, out double3 east, out double3 north, out double3 up)
        {
            var x = new double3(1, 0, 0);
            var y = new double3(0, 1, 0);
            var z = new double3(0, 0, 1);
            switch (axis)
            {
                case UpAxis.X:
                    east = y;
                    north = z;
                    up = x;
                    break;
                case UpAxis.Y:
                    east = x;
                    north = -z;
                    up = y;
                    break;
                default:
                    east = x;
                    north = y;
                    up = z;
                    break;
            }
        }
    }

    /// <summary>The axis of a cloud that points up.</summary>
    public enum UpAxis
    {
        X = 0,
        Y = 1,
        Z = 2,
    }
}
