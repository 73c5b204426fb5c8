using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using NUnit.Framework;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Tests.Core
{
    public class FilterExpressionTests
    {
        static PointBatch Points(int count, Func<int, double3> at) =>
            TestBatches.OfPositions(Enumerable.Range(0, count).Select(at).ToArray());

        static unsafe List<double3> Left(string condition, PointBatch batch, PositionTransform transform)
        {
            var steps = FilterSteps.Of(new[] { FilterExpression.Parse(condition) }, batch, transform);
            byte* results = stackalloc byte[FilterSteps.ResultsBytes];
            double* operands = stackalloc double[2 * ColumnValues.BatchLength];
            var memory = new FilterMemory { Results = results, Left = operands, Right = operands + ColumnValues.BatchLength };
            var left = new List<double3>();
            fixed (FilterStep* step = steps)
                for (int first = 0; first < batch.Count; first += ColumnValues.BatchLength)
                {
                    int points = Math.Min(ColumnValues.BatchLength, batch.Count - first);
                    FilterSteps.Evaluate(step, steps.Length, (byte*)batch.Bytes.GetUnsafeReadOnlyPtr(), first, points, memory);
                    for (int i = 0; i < points; i++)
                        if (results[i] != 0)
                            left.Add(PositionAt(batch, transform, first + i));
                }
            return left;
        }

        static unsafe double3 PositionAt(PointBatch batch, PositionTransform transform, int index) =>
            PositionColumns.Of(batch).GeoAt((byte*)batch.Bytes.GetUnsafeReadOnlyPtr(), transform, index);

        static void IsFiltered(string condition, PointBatch batch, Func<double3, bool> isWanted)
        {
            var all = Enumerable.Range(0, batch.Count).Select(i => PositionAt(batch, PositionTransform.Identity, i)).ToList();
            var left = Left(condition, batch, PositionTransform.Identity);
            Assert.That(left.Select(Text), Is.EqualTo(all.Where(isWanted).Select(Text)));
        }

        static string Text(double3 p) => p.x.ToString("R") + " " + p.y.ToString("R") + " " + p.z.ToString("R");

        /// <summary>A condition at random, and what it means.</summary>
        static (string Text, Func<double3, bool> Holds) Condition(System.Random random, int depth)
        {
            int kind = depth == 0 ? 0 : random.Next(4);
            if (kind == 0)
            {
                int axis = random.Next(3), op = random.Next(6);
                double than = random.Next(-3, 4);
                string text = "XYZ"[axis] + new[] { "==", "!= ", " < ", " <=", ">", " >= " }[op] +
                    than.ToString(CultureInfo.InvariantCulture);
                return (text, p => op == 0 ? p[axis] == than : op == 1 ? p[axis] != than : op == 2 ? p[axis] < than
                    : op == 3 ? p[axis] <= than : op == 4 ? p[axis] > than : p[axis] >= than);
            }
            var left = Condition(random, depth - 1);
            if (kind == 1)
                return ("!(" + left.Text + ")", p => !left.Holds(p));
            var right = Condition(random, depth - 1);
            return kind == 2 ? ("(" + left.Text + ") && (" + right.Text + ")", p => left.Holds(p) && right.Holds(p))
                : ("(" + left.Text + " || " + right.Text + ")", (Func<double3, bool>)(p => left.Holds(p) || right.Holds(p)));
        }

        [Test]
        public void Where_AnyCondition_MatchesPointByPoint([Range(0, 19)] int seed)
        {
            var random = new System.Random(seed);
            double[] values = { -3, -2, -1, 0, 1, 2, 3, double.NaN, double.PositiveInfinity, double.NegativeInfinity };
            double Any() => values[random.Next(values.Length)];
            using var batch = Points(20000, _ => new double3(Any(), Any(), Any()));
            var condition = Condition(random, 5);
            IsFiltered(condition.Text, batch, condition.Holds);
        }

        [Test]
        public void Where_AndBindsMoreThanOr()
        {
            using (var batch = Points(1000, i => new double3(i % 2, i / 2 % 2, i / 4 % 2)))
                IsFiltered("X==1 || Y==1 && Z==1", batch, p => p.x == 1 || p.y == 1 && p.z == 1);
        }

        [Test]
        public void Where_ScaledValues_EqualTheirText()
        {
            var transform = new PositionTransform { Scale = new double3(0.01, 0.01, 0.01), Offset = new double3(500000, 0, 0) };
            using (var batch = Points(100, i => new double3(i, i, i)))
                for (int i = 0; i < 100; i++)
                {
                    string x = (500000 + i / 100m).ToString(CultureInfo.InvariantCulture);
                    string y = (i / 100m).ToString(CultureInfo.InvariantCulture);
                    using (var again = Points(100, n => new double3(n, n, n)))
                        Assert.That(Left("X == " + x + " && !(Y < " + y + ") && Y <= " + y, again, transform).Count,
                            Is.EqualTo(1), x);
                }
        }

        [TestCase("X >", "an attribute or a number at character 4, got the end", 3)]
        [TestCase("X > 1 &", "&&, || or the end at character 7, got '&'", 6)]
        [TestCase("(X > 1", ") at character 7", 6)]
        [TestCase("X = 1", "==, !=, <, <=, > or >= at character 3", 2)]
        [TestCase("1.2.3 < X", "an attribute or a number at character 1", 0)]
        [TestCase("", "an attribute or a number at character 1", 0)]
        [TestCase("X > 1 Y < 2", "&&, || or the end at character 7", 6)]
        [TestCase("\"X > 1", "a name that ends in \" at character 1", 0)]
        public void Where_WrongCondition_NamesTheCharacter(string text, string message, int caret)
        {
            var e = Assert.Throws<FormatException>(() => FilterExpression.Parse(text));
            Assert.That(e.Message, Does.Contain(message));
            Assert.That(e.Message.Split('\n').Last(), Is.EqualTo("  " + new string(' ', caret) + "^"));
        }

        [Test]
        public void Where_DeepOrLong_IsBounded()
        {
            string deep = new string('(', 32) + "X==0" + new string(')', 32);
            Assert.DoesNotThrow(() => FilterExpression.Parse(deep));
            Assert.Throws<FormatException>(() => FilterExpression.Parse("(" + deep + ")"));
            Assert.Throws<FormatException>(() => FilterExpression.Parse(new string('!', 1_000_000) + "X==0"));
            Assert.Throws<FormatException>(() => FilterExpression.Parse(string.Join("||", Enumerable.Repeat("X==0", 513))));
            string waiting = "X==0";
            for (int i = 0; i < 32; i++)
                waiting = "Y==1 || Z==2 && (" + waiting + ")";
            using (var batch = Points(600, i => new double3(i % 2, i % 3, i % 5)))
                IsFiltered(waiting, batch, p => p.y == 1 || p.z == 2 && p.x == 0);
        }
    }
}
