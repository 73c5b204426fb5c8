using FastPoints.Core;
using FastPoints.Reading;

namespace FastPoints.Las
{
    internal static class LasTransform
    {
        // Most common in LAS files.
        const double TypicalScale = 0.01;

        static readonly string[] s_axes = { "x", "y", "z" };

        // An axis whose scale is zero or not finite would lose its points, so it takes the scale of another axis (x and y each
        // other's first) or 0.01; an offset that is not finite becomes 0. Each of these is a warning. A negative scale is kept:
        // it mirrors, and that is exact.
        public static PositionTransform Read(LasHeader header, SourceInfo info)
        {
            var transform = new PositionTransform { Scale = header.Scale, Offset = header.Offset };
            for (int axis = 0; axis < 3; axis++)
            {
                double offset = header.Offset[axis];
                if (!IsFinite(offset))
                {
                    transform.Offset[axis] = 0;
                    info.Warn(LasHeader.At.Offset + 8 * axis, "offset of " + s_axes[axis] + ": wanted a number, got "
                        + NumberText.Of(offset) + ": read as 0");
                }
                double scale = header.Scale[axis];
                if (IsUsable(scale))
                    continue;
                double assumed = TypicalScale;
                for (int other = 2; other >= 0; other--)
                    if (other != axis && IsUsable(header.Scale[other]))
                        assumed = header.Scale[other];
                transform.Scale[axis] = assumed;
                info.Warn(LasHeader.At.Scale + 8 * axis, "scale of " + s_axes[axis] + ": wanted a number that is not 0, got "
                    + NumberText.Of(scale) + ": read as " + NumberText.Of(assumed));
            }
            return transform;
        }

        // A scale that moves a 32-bit integer beyond the doubles is as good as infinite.
        static bool IsUsable(double scale) => scale != 0 && IsFinite(scale) && IsFinite(scale * int.MinValue * 2);

        static bool IsFinite(double value) => !double.IsNaN(value) && !double.IsInfinity(value);
    }
}
