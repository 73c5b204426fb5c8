using FastPoints.Points;
using Unity.Mathematics;

namespace FastPoints.Files
{
    /// <summary>How a LAZ file's whole numbers become those of another scale and offset: exactly, or not at all.</summary>
    unsafe struct LazFilePlacing
    {
        /// <summary>Whether scale and offset are the same, and nothing is to do.</summary>
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
                // Below 2^28 * 2^31 + 2^59: no overflow.
                long place = value * Factor + Shift;
                if (place != (int)place)
                    return false;
                value = (int)place;
                return true;
            }
        }

        /// <param name="header">Of the LAZ file.</param>
        /// <returns>Whether the file's steps are whole steps of the grid.</returns>
        public static bool TryMake(byte* header, in PositionTransform grid, out LazFilePlacing placing)
        {
            double* scale = (double*)(header + LasHeader.At.Scale), offset = (double*)(header + LasHeader.At.Offset);
            placing = default;
            // Nodes that are all alike are read whatever their scale is, zero or no number among them.
            placing.IsSame = AreSame(scale, offset, grid);
            return placing.IsSame || TryMake(scale[0], offset[0], grid.Scale.x, grid.Offset.x, out placing.m_x)
                && TryMake(scale[1], offset[1], grid.Scale.y, grid.Offset.y, out placing.m_y)
                && TryMake(scale[2], offset[2], grid.Scale.z, grid.Offset.z, out placing.m_z);
        }

        /// <param name="position">X, Y, Z of a record; left unfinished where false is returned.</param>
        /// <returns>Whether 32 bits hold the place on the grid.</returns>
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

        static bool TryMake(double scale, double offset, double step, double origin, out Axis axis)
        {
            axis = default;
            return CommonGrid.TryPlace(scale, offset, step, origin, out axis.Factor, out axis.Shift, out double loss)
                && loss == 0 && axis.Factor != 0;
        }
    }
}
