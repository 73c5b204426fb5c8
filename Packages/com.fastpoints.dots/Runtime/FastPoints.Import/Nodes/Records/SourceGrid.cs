using FastPoints.Core;
using Unity.Mathematics;

namespace FastPoints.Nodes
{
    /// <summary>The conversion of one axis of a source's numbers to the cloud's grid. Blittable.</summary>
    internal struct SourceAxis
    {
        /// <summary>For whole numbers: grid = stored * <see cref="Factor"/> + <see cref="Shift"/>, exact.</summary>
        public bool IsInteger;
        public long Factor;
        public long Shift;

        /// <summary>For other numbers: geo = stored * Scale + Offset, grid = round((geo - Origin) / Step).</summary>
        public double Scale;
        public double Offset;
        public double Origin;
        public double Step;
    }

    /// <summary>Maps one source's stored positions to positions on the cloud's grid. Blittable, for jobs.</summary>
    internal struct SourceGrid
    {
        /// <summary>Positions farther out are left out, so that sums of positions and sides stay within a long.</summary>
        public const long Limit = CommonGrid.Limit;

        /// <summary>Marks an invalid position: far outside <see cref="Limit"/>.</summary>
        public const long InvalidPosition = CommonGrid.InvalidPosition;

        public SourceAxis X;
        public SourceAxis Y;
        public SourceAxis Z;

        /// <summary>Computes grid numbers of consecutive values of one axis: <see cref="InvalidPosition"/> for numbers that are
        /// not finite or too far out.</summary>
        /// <param name="worstLoss">Raised to the largest distance, in steps, between a number and its place on the grid.</param>
        public static unsafe void ToGrid(in SourceAxis axis, byte* stored, AttributeType type, int count, long* grid,
            ref double worstLoss)
        {
            if (axis.IsInteger)
            {
                IntegersToGrid(stored, type, count, axis.Factor, axis.Shift, grid);
                return;
            }
            double perStep = 1 / axis.Step;
            for (int i = 0; i < count; i++)
            {
                double value = type == AttributeType.Float32 ? ((float*)stored)[i] : ((double*)stored)[i];
                double steps = (value * axis.Scale + axis.Offset - axis.Origin) * perStep;
                if (!(math.abs(steps) < Limit))
                {
                    grid[i] = InvalidPosition;
                    continue;
                }
                double whole = math.round(steps);
                worstLoss = math.max(worstLoss, math.abs(steps - whole));
                grid[i] = (long)whole;
            }
        }

        /// <summary>The same for whole numbers whose grid numbers are less than 2^32 above an origin: offsets from it.</summary>
        public static unsafe void ToOffsets(in SourceAxis axis, byte* stored, AttributeType type, int count, long origin,
            uint* offsets)
        {
            if (type == AttributeType.Int32)
            {
                // Modulo 2^32, which loses nothing of the result.
                uint factor = (uint)axis.Factor, shift = (uint)(axis.Shift - origin);
                for (int i = 0; i < count; i++)
                    offsets[i] = ((uint*)stored)[i] * factor + shift;
                return;
            }
            for (int i = 0; i < count; i++, stored += type.SizeOf())
            {
                long grid;
                IntegersToGrid(stored, type, 1, axis.Factor, axis.Shift, &grid);
                offsets[i] = (uint)(grid - origin);
            }
        }

        /// <summary>The same for one stored number: exact for whole numbers below 2^53.</summary>
        public static long ToGrid(in SourceAxis axis, double stored)
        {
            if (axis.IsInteger)
                return math.abs(stored * axis.Factor) < Limit ? (long)stored * axis.Factor + axis.Shift : InvalidPosition;
            double steps = (stored * axis.Scale + axis.Offset - axis.Origin) * (1 / axis.Step);
            return math.abs(steps) < Limit ? (long)math.round(steps) : InvalidPosition;
        }

        static unsafe void IntegersToGrid(byte* column, AttributeType type, int count, long factor, long shift, long* grid)
        {
            switch (type)
            {
                case AttributeType.Int32:
                    if (factor == 1 && shift == 0)
                    {
                        for (int i = 0; i < count; i++)
                            grid[i] = ((int*)column)[i];
                        return;
                    }
                    for (int i = 0; i < count; i++)
                        grid[i] = ((int*)column)[i] * factor + shift;
                    return;
                case AttributeType.UInt32:
                    for (int i = 0; i < count; i++)
                        grid[i] = ((uint*)column)[i] * factor + shift;
                    return;
                case AttributeType.Int16:
                    for (int i = 0; i < count; i++)
                        grid[i] = ((short*)column)[i] * factor + shift;
                    return;
                case AttributeType.UInt16:
                    for (int i = 0; i < count; i++)
                        grid[i] = ((ushort*)column)[i] * factor + shift;
                    return;
                case AttributeType.Int8:
                    for (int i = 0; i < count; i++)
                        grid[i] = ((sbyte*)column)[i] * factor + shift;
                    return;
                case AttributeType.UInt8:
                    for (int i = 0; i < count; i++)
                        grid[i] = column[i] * factor + shift;
                    return;
                case AttributeType.Int64:
                    long max = Limit / math.max(1, math.abs(factor));
                    for (int i = 0; i < count; i++)
                    {
                        long stored = ((long*)column)[i];
                        grid[i] = stored > -max && stored < max ? stored * factor + shift : InvalidPosition;
                    }
                    return;
                case AttributeType.UInt64:
                    ulong unsignedMax = (ulong)(Limit / math.max(1, math.abs(factor)));
                    for (int i = 0; i < count; i++)
                    {
                        ulong stored = ((ulong*)column)[i];
                        grid[i] = stored < unsignedMax ? (long)stored * factor + shift : InvalidPosition;
                    }
                    return;
                default:
                    for (int i = 0; i < count; i++)
                        grid[i] = InvalidPosition;
                    return;
            }
        }
    }
}
