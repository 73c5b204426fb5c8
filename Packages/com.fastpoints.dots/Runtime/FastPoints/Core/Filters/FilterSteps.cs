using System.Collections.Generic;
using Unity.Mathematics;

namespace FastPoints
{
    // What evaluating takes on the stack: FilterSteps.ResultsBytes, and ColumnValues.BatchLength values of each operand.
    internal unsafe struct FilterMemory
    {
        public byte* Results;
        public double* Left;
        public double* Right;
    }

    internal static unsafe class FilterSteps
    {
        const int BatchLength = ColumnValues.BatchLength;

        // Parentheses nest so deep at most, each with an "or" and an "and" that wait.
        public const int ResultsBytes = (2 * FilterExpression.MaxDepth + 8) * BatchLength;

        // Those of each expression, one after another: all must hold.
        public static FilterStep[] Of(IReadOnlyList<FilterExpression> expressions, PointBatch batch,
            in PositionTransform transform)
        {
            var steps = new List<FilterStep>();
            foreach (var expression in expressions)
            {
                for (int i = 0; i < expression.Steps.Count; i++)
                {
                    var step = expression.Steps[i];
                    Bind(ref step.Left, expression.Names[i].Left, batch, transform);
                    Bind(ref step.Right, expression.Names[i].Right, batch, transform);
                    RoundLike(step.Left, ref step.Right);
                    RoundLike(step.Right, ref step.Left);
                    bool isScaled = IsScaled(step.Left) || IsScaled(step.Right);
                    step.RelativeTolerance = isScaled ? 4.5e-16 : 0;
                    step.AbsoluteTolerance = 4.5e-16 * (math.abs(step.Left.Offset) + math.abs(step.Right.Offset));
                    steps.Add(step);
                }
                if (expression != expressions[0])
                    steps.Add(new FilterStep { Op = FilterOp.And });
            }
            return steps.ToArray();
        }

        static bool IsScaled(in FilterOperand operand) => operand.IsAttribute && (operand.Scale != 1 || operand.Offset != 0);

        // A number that is compared with 32-bit floats is one of these.
        static void RoundLike(in FilterOperand other, ref FilterOperand number)
        {
            if (!number.IsAttribute && other.IsAttribute && other.Column.Type == AttributeType.Float32 && !IsScaled(other))
                number.Number = (float)number.Number;
        }

        static void Bind(ref FilterOperand operand, string name, PointBatch batch, in PositionTransform transform)
        {
            if (name == null)
                return;
            int column = batch.Schema.IndexOf(name);
            operand.Column = batch.Column(column);
            int axis = AttributeNames.AxisOf(name);
            operand.Scale = axis < 0 ? batch.Schema[column].Scale : transform.Scale[axis];
            operand.Offset = axis < 0 ? batch.Schema[column].Offset : transform.Offset[axis];
        }

        // A byte a point at the begin of the memory's results: 1 where all holds. At most ColumnValues.BatchLength points.
        public static void Evaluate(FilterStep* steps, int count, byte* columns, int first, int points, in FilterMemory memory)
        {
            double* left = memory.Left, right = memory.Right;
            byte* top = memory.Results - BatchLength;
            for (int s = 0; s < count; s++)
            {
                var step = steps[s];
                if (step.Op == FilterOp.Not)
                {
                    for (int i = 0; i < points; i++)
                        top[i] ^= 1;
                    continue;
                }
                if (step.Op == FilterOp.And || step.Op == FilterOp.Or)
                {
                    byte* other = top;
                    top -= BatchLength;
                    if (step.Op == FilterOp.And)
                        for (int i = 0; i < points; i++)
                            top[i] &= other[i];
                    else
                        for (int i = 0; i < points; i++)
                            top[i] |= other[i];
                    continue;
                }
                Load(columns, step.Left, first, points, left);
                Load(columns, step.Right, first, points, right);
                top += BatchLength;
                Compare(step, points, left, right, top);
            }
        }

        static void Load(byte* bytes, in FilterOperand operand, int first, int points, double* values)
        {
            if (!operand.IsAttribute)
            {
                for (int i = 0; i < points; i++)
                    values[i] = operand.Number;
                return;
            }
            ColumnValues.ToDoubles(bytes + operand.Column.OffsetBytes, operand.Column.Type, first, points, values);
            double scale = operand.Scale, offset = operand.Offset;
            if (scale != 1 || offset != 0)
                for (int i = 0; i < points; i++)
                    values[i] = values[i] * scale + offset;
        }

        // NaN is not equal, less or greater.
        static void Compare(in FilterStep step, int points, double* left, double* right, byte* to)
        {
            if (step.RelativeTolerance > 0)
                for (int i = 0; i < points; i++)
                {
                    double reach = step.AbsoluteTolerance + step.RelativeTolerance * (math.abs(left[i]) + math.abs(right[i]));
                    left[i] = math.abs(left[i] - right[i]) <= reach ? right[i] : left[i];
                }
            switch (step.Op)
            {
                case FilterOp.Equal:
                    for (int i = 0; i < points; i++)
                        to[i] = (byte)(left[i] == right[i] ? 1 : 0);
                    break;
                case FilterOp.NotEqual:
                    for (int i = 0; i < points; i++)
                        to[i] = (byte)(left[i] != right[i] ? 1 : 0);
                    break;
                case FilterOp.Less:
                    for (int i = 0; i < points; i++)
                        to[i] = (byte)(left[i] < right[i] ? 1 : 0);
                    break;
                case FilterOp.LessOrEqual:
                    for (int i = 0; i < points; i++)
                        to[i] = (byte)(left[i] <= right[i] ? 1 : 0);
                    break;
                case FilterOp.Greater:
                    for (int i = 0; i < points; i++)
                        to[i] = (byte)(left[i] > right[i] ? 1 : 0);
                    break;
                default:
                    for (int i = 0; i < points; i++)
                        to[i] = (byte)(left[i] >= right[i] ? 1 : 0);
                    break;
            }
        }
    }
}
