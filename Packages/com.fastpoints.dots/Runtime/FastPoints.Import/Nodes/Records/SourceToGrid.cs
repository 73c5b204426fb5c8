using System;
using System.Collections.Generic;
using FastPoints.Reading;
using FastPoints.Sampling;
using Unity.Mathematics;

namespace FastPoints.Nodes
{
    internal struct SourceAxis
    {
        public bool UsesFactor; // For whole numbers: grid = stored * Factor + Shift, exact.
        public long Factor;
        public long Shift;
        public double Scale; // For other numbers: geo = stored * Scale + Offset, grid = round((geo - Origin) / Step).
        public double Offset;
        public double Origin;
        public double Step;
    }

    internal struct SourceToGrid
    {
        /// <summary>Positions beyond it are left out, so that sums of positions and sides fit a long.</summary>
        public const long Limit = CommonGrid.Limit;
        public const long InvalidPosition = CommonGrid.InvalidPosition; // Marks an invalid position: far outside Limit.

        public SourceAxis X;
        public SourceAxis Y;
        public SourceAxis Z;

        /// <summary>Computes grid numbers of consecutive values of one axis: <see cref="InvalidPosition"/> for numbers that are
        /// not finite or too far out.</summary>
        /// <param name="maxRoundingSteps">Raised to the largest distance, in steps, between a number and its grid point.</param>
        public static unsafe void ToGrid(in SourceAxis axis, byte* stored, AttributeType type, int count, long* grid,
            ref double maxRoundingSteps)
        {
            if (axis.UsesFactor)
            {
                IntegersToGrid(stored, type, count, axis.Factor, axis.Shift, grid);
                return;
            }
            double perStep = 1 / axis.Step;
            if (!type.IsFloat())
                IntegersToGrid(stored, type, count, 1, 0, grid);
            for (int i = 0; i < count; i++)
            {
                double value = !type.IsFloat() ? grid[i] : type == AttributeType.Float32 ? ((float*)stored)[i]
                    : ((double*)stored)[i];
                double steps = (value * axis.Scale + axis.Offset - axis.Origin) * perStep;
                if (!(math.abs(steps) < Limit))
                {
                    grid[i] = InvalidPosition;
                    continue;
                }
                double whole = math.round(steps);
                maxRoundingSteps = math.max(maxRoundingSteps, math.abs(steps - whole));
                grid[i] = (long)whole;
            }
        }

        /// <summary>The same for whole numbers whose grid numbers are less than 2^32 above an origin: offsets from it.</summary>
        public static unsafe void IntegersToOffsets(in SourceAxis axis, byte* stored, AttributeType type, int count, long origin,
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
            if (axis.UsesFactor)
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

    /// <summary>Chooses the one grid of a cloud and how each source's numbers map to it. Whole numbers keep every digit if their
    /// scales and offsets have a common step; floats get a step that is a power of two.</summary>
    internal sealed class GridChoice
    {
        /// <summary>A float source's extent takes at most 2^31 steps, so that offsets in the octree fit 32 bits.</summary>
        const int FloatExtentLog2 = 31;

        public CloudGrid Grid;
        public SourceToGrid[] Sources;
        public RecordLayout RecordLayout; // For the largest range of grid numbers: wide if it does not fit 32 bits.

        /// <param name="hasUniformStep">Whether the step is the same on all axes.</param>
        /// <exception cref="PointCloudException">The scales and offsets do not fit any grid of 2^60 steps.</exception>
        public static GridChoice Choose(IReadOnlyList<SourceInfo> infos, IReadOnlyList<SampleStatistics> samples,
            int attributeBytes, bool hasUniformStep = false)
        {
            var choice = new GridChoice { Sources = new SourceToGrid[infos.Count] };
            var steps = new double[3];
            for (int axis = 0; axis < 3; axis++)
                steps[axis] = IsInteger(infos, axis) ? CommonStep(infos, axis) : FloatStep(infos, samples, axis, NameOf(axis));
            double common = CommonGrid.StepOf(steps, new double[3]);
            bool isNarrow = true;
            var origin = default(Grid3);
            for (int axis = 0; axis < 3; axis++)
            {
                string name = NameOf(axis);
                double step = hasUniformStep ? common : steps[axis];
                var axes = ChooseAxis(infos, axis, step, out double axisOrigin);
                choice.Grid.Step[axis] = step;
                choice.Grid.Origin[axis] = axisOrigin;
                long lowest = long.MaxValue, highest = long.MinValue;
                for (int i = 0; i < axes.Length; i++)
                {
                    if (axis == 0)
                        choice.Sources[i].X = axes[i];
                    else if (axis == 1)
                        choice.Sources[i].Y = axes[i];
                    else
                        choice.Sources[i].Z = axes[i];
                    var type = infos[i].Schema[infos[i].Schema.IndexOf(name)].Type;
                    isNarrow &= axes[i].UsesFactor && type.SizeOf() <= 4;
                    type.RangeUpTo32Bits(out long min, out long max);
                    long a = min * axes[i].Factor + axes[i].Shift, b = max * axes[i].Factor + axes[i].Shift;
                    lowest = Math.Min(lowest, Math.Min(a, b));
                    highest = Math.Max(highest, Math.Max(a, b));
                }
                isNarrow = isNarrow && highest - lowest <= uint.MaxValue;
                if (axis == 0)
                    origin.X = lowest;
                else if (axis == 1)
                    origin.Y = lowest;
                else
                    origin.Z = lowest;
            }
            choice.RecordLayout = new RecordLayout(!isNarrow, origin, attributeBytes);
            return choice;
        }

        static string NameOf(int axis) => axis == 0 ? AttributeNames.X : axis == 1 ? AttributeNames.Y : AttributeNames.Z;

        static bool IsInteger(IReadOnlyList<SourceInfo> infos, int axis)
        {
            bool isInteger = true;
            foreach (var info in infos)
                isInteger &= !info.Schema[info.Schema.IndexOf(NameOf(axis))].Type.IsFloat();
            return isInteger;
        }

        static SourceAxis[] ChooseAxis(IReadOnlyList<SourceInfo> infos, int axis, double step, out double origin)
        {
            origin = IsInteger(infos, axis) ? infos[0].Transform.Offset[axis] : 0;
            var axes = new SourceAxis[infos.Count];
            for (int i = 0; i < axes.Length; i++)
                axes[i] = SourceAxisOf(infos[i], axis, NameOf(axis), step, origin);
            return axes;
        }

        /// <summary>Maps one source's numbers to a given grid: that of a converted cloud, to compare it with its
        /// source.</summary>
        /// <exception cref="PointCloudException">The source's scales and offsets do not fit the grid.</exception>
        public static SourceToGrid OnGrid(SourceInfo info, CloudGrid grid)
        {
            SourceAxis On(int axis, string name) => SourceAxisOf(info, axis, name, grid.Step[axis], grid.Origin[axis]);
            return new SourceToGrid { X = On(0, AttributeNames.X), Y = On(1, AttributeNames.Y), Z = On(2, AttributeNames.Z) };
        }

        static SourceAxis SourceAxisOf(SourceInfo info, int axis, string name, double step, double origin)
        {
            double scale = info.Transform.Scale[axis], offset = info.Transform.Offset[axis];
            var result = new SourceAxis { Scale = scale, Offset = offset, Origin = origin, Step = step };
            if (info.Schema[info.Schema.IndexOf(name)].Type.IsFloat())
                return result;
            if (!CommonGrid.TryRescale(scale, offset, step, origin, out var placed))
            {
                throw new PointCloudException(FailureCode.Unsupported, info.Path, -1,
                    "scale and offset of " + name + ": no grid holds them together with the other files'");
            }
            double loss;
            (result.Factor, result.Shift, loss) = placed;
            result.UsesFactor = true;
            if (loss > step)
            {
                // The scale is no multiple of the step: each coordinate is rounded to the nearest one.
                result.UsesFactor = false;
                loss = step / 2;
            }
            if (loss > 0)
                info.Warn(-1, name + " does not fit the common grid: moved by up to " + NumberText.Of(loss));
            return result;
        }

        static double CommonStep(IReadOnlyList<SourceInfo> infos, int axis)
        {
            var scales = new double[infos.Count];
            var offsets = new double[infos.Count];
            for (int i = 0; i < scales.Length; i++)
            {
                scales[i] = infos[i].Transform.Scale[axis];
                offsets[i] = infos[i].Transform.Offset[axis];
            }
            return CommonGrid.StepOf(scales, offsets);
        }

        /// <summary>A power of two that keeps all digits of the sample if its extent then fits 31 bits.</summary>
        static double FloatStep(IReadOnlyList<SourceInfo> infos, IReadOnlyList<SampleStatistics> samples, int axis, string name)
        {
            double min = double.PositiveInfinity, max = double.NegativeInfinity, finestScale = double.PositiveInfinity;
            int digit = int.MaxValue;
            for (int i = 0; i < infos.Count; i++)
            {
                double scale = infos[i].Transform.Scale[axis], offset = infos[i].Transform.Offset[axis];
                double a = samples[i].Min[axis] * scale + offset, b = samples[i].Max[axis] * scale + offset;
                min = Math.Min(min, Math.Min(a, b));
                max = Math.Max(max, Math.Max(a, b));
                if (infos[i].Schema[infos[i].Schema.IndexOf(name)].Type.IsFloat())
                    digit = Math.Min(digit, samples[i].LowestDigit[axis]);
                else
                    finestScale = Math.Min(finestScale, Math.Abs(scale));
            }
            if (!(min <= max))
                return 1;
            if (finestScale < double.PositiveInfinity)
                return finestScale;
            double largest = Math.Max(Math.Abs(min), Math.Abs(max));
            if (digit == int.MaxValue || largest == 0)
                return 1;
            digit = Math.Max(digit, Exponent(max - min) + 1 - FloatExtentLog2);
            digit = Math.Max(digit, Exponent(largest) + 1 - 58);
            return math.pow(2.0, Math.Max(-1000, Math.Min(900, digit)));
        }

        /// <summary>The power of two at or below a positive number; very low for zero.</summary>
        static int Exponent(double value) => value > 0 ? (int)Math.Floor(Math.Log(value, 2)) : -1000;
    }
}
