using FastPoints.Core;
using FastPoints.Las;
using Unity.Mathematics;

namespace FastPoints.Laz
{
    /// <summary>How a LAZ file's whole numbers are converted to another scale and offset: exactly, to the nearest whole number of
    /// steps if allowed, or not at all.</summary>
    unsafe struct LazFilePlacing
    {
        /// <summary>Whether scale and offset are the same, so that there is nothing to do.</summary>
        public bool IsSame;

        Axis m_x;
        Axis m_y;
        Axis m_z;

        struct Axis
        {
            public long Factor;
            public long Shift;

            public readonly bool TryPlace(ref int value)
            {
                // This stays below 2^28 * 2^31 + 2^59, so it cannot overflow.
                long place = value * Factor + Shift;
                if (place != (int)place)
                    return false;
                value = (int)place;
                return true;
            }
        }

        /// <param name="header">The header of the LAZ file.</param>
        /// <param name="roundsOffset">If steps are the same, offsets are rounded to the nearest that lie whole steps
        /// apart.</param>
        /// <returns>Whether the file's steps are whole steps of the grid.</returns>
        public static bool TryMake(byte* header, in PositionTransform grid, bool roundsOffset, out LazFilePlacing placing)
        {
            double* scale = (double*)(header + LasHeader.At.Scale), offset = (double*)(header + LasHeader.At.Offset);
            placing = default;
            // Nodes that are all alike are read whatever their scale is, even zero or NaN.
            placing.IsSame = AreSame(scale, offset, grid);
            return placing.IsSame || TryMake(scale[0], offset[0], grid.Scale.x, grid.Offset.x, roundsOffset, out placing.m_x)
                && TryMake(scale[1], offset[1], grid.Scale.y, grid.Offset.y, roundsOffset, out placing.m_y)
                && TryMake(scale[2], offset[2], grid.Scale.z, grid.Offset.z, roundsOffset, out placing.m_z);
        }

        /// <param name="position">X, Y, Z of a record; left half-converted if false is returned.</param>
        /// <returns>Whether the position on the grid fits into 32 bits.</returns>
        public readonly bool TryPlace(int* position) =>
            m_x.TryPlace(ref position[0]) && m_y.TryPlace(ref position[1]) && m_z.TryPlace(ref position[2]);

        static bool AreSame(double* scale, double* offset, in PositionTransform grid)
        {
            for (int axis = 0; axis < 3; axis++)
                if (math.aslong(scale[axis]) != math.aslong(grid.Scale[axis])
                    || math.aslong(offset[axis]) != math.aslong(grid.Offset[axis]))
                    return false;
            return true;
        }

        static bool TryMake(double scale, double offset, double step, double origin, bool roundsOffset, out Axis axis)
        {
            axis = default;
            if (roundsOffset)
            {
                double shift = (offset - origin) / step;
                bool isNear = math.abs(scale - step) <= 1e-9 * math.abs(step) && math.abs(shift) <= int.MaxValue;
                axis = new Axis { Factor = 1, Shift = isNear ? (long)math.round(shift) : 0 };
                return isNear;
            }
            bool isPlaced = CommonGrid.TryPlace(scale, offset, step, origin, out var placed);
            axis = new Axis { Factor = placed.Factor, Shift = placed.Shift };
            return isPlaced && placed.Loss == 0 && axis.Factor != 0;
        }
    }
}
