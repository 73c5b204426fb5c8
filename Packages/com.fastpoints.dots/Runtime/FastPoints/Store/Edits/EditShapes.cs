using System;
using Unity.Mathematics;

namespace FastPoints.Store
{
    // How much of a box a shape holds.
    internal enum EditReach
    {
        None,
        Some,
        All,
    }

    // A box from A to B, both included; or a ball around A with B's radii in steps, which differ where a grid's steps do.
    internal struct EditShape
    {
        public const long MaxUnequalRadius = 1 << 20; // Larger radii that differ would not fit the arithmetic.

        public Grid3 A;
        public Grid3 B;
        public bool IsBall;

        // The positions whose coordinates lie in a box, faces included. What rounding alone puts outside counts as inside, as in
        // LocalClip.
        public static EditShape Box(in CloudGrid grid, double3 min, double3 max)
        {
            var reach = (math.abs(min) + math.abs(max) + math.abs(grid.Origin)) * 4.5e-16;
            return new EditShape
            {
                A = GridOf(math.ceil((min - grid.Origin - reach) / grid.Step)),
                B = GridOf(math.floor((max - grid.Origin + reach) / grid.Step)),
            };
        }

        public static EditShape Of(GridCube cube)
        {
            long last = cube.Side - 1;
            return new EditShape { A = cube.Corner, B = cube.Corner + new Grid3(last, last, last) };
        }

        // Around a node's own points, without those of its inlined leaves.
        public static EditShape OfPoints(in NodeRecord node)
        {
            int at = node.BoundsShift;
            var min = node.Corner + new Grid3((long)node.MinX << at, (long)node.MinY << at, (long)node.MinZ << at);
            var end = node.Corner + new Grid3(node.MaxX + 1L << at, node.MaxY + 1L << at, node.MaxZ + 1L << at);
            return new EditShape { A = min, B = end - new Grid3(1, 1, 1) };
        }

        public readonly EditShape Bounds => IsBall ? new EditShape { A = A - B, B = A + B } : this;

        public static Grid3 GridOf(double3 steps)
        {
            steps = math.clamp(steps, -EditOperation.MaxCoordinate, EditOperation.MaxCoordinate);
            return new Grid3((long)steps.x, (long)steps.y, (long)steps.z);
        }

        public readonly bool IsRound => B.X == B.Y && B.Y == B.Z;

        public readonly bool Holds(Grid3 p)
        {
            if (!IsBall)
                return Grid3.Min(p, A) == A && Grid3.Max(p, B) == B;
            long x = p.X - A.X, y = p.Y - A.Y, z = p.Z - A.Z, radius = B.X;
            if (math.abs(x) > B.X || math.abs(y) > B.Y || math.abs(z) > B.Z)
                return false;
            if (IsRound && radius < 1 << 30)
                return x * x + y * y + z * z <= radius * radius;
            if (!IsRound)
                (x, y, z, radius) = (x * B.Y * B.Z, y * B.X * B.Z, z * B.X * B.Y, radius * B.Y * B.Z);
            var distance = Signed128.Product(x, x) + Signed128.Product(y, y) + Signed128.Product(z, z);
            return distance.CompareTo(Signed128.Product(radius, radius)) <= 0;
        }

        public readonly EditReach ReachOf(in EditShape box)
        {
            // The nearest of its positions, and the farthest.
            var center = IsBall ? A : Grid3.Max(A, Grid3.Min(B, box.A));
            if (!Holds(Grid3.Min(Grid3.Max(center, box.A), box.B)))
                return EditReach.None;
            return Holds(IsBall ? new Grid3(Farther(box.A.X, box.B.X, A.X), Farther(box.A.Y, box.B.Y, A.Y),
                Farther(box.A.Z, box.B.Z, A.Z)) : box.A) && (IsBall || Holds(box.B)) ? EditReach.All : EditReach.Some;
        }

        static long Farther(long a, long b, long from) => math.abs(a - from) > math.abs(b - from) ? a : b;
    }

    // Where polygons are drawn: a position is seen at u = dot(position - Origin, U), v likewise, so that U and V say how finely,
    // and from where. They reach without end along what is across both. With W they are a pyramid's section, and Origin is the
    // eye: what lies before it, at a depth of d = dot(position - Origin, W) > 0, is seen at floor(dot(position - Origin, U) *
    // 2^20 / d), v likewise. All of it in whole numbers.
    internal struct EditPrism
    {
        public const int SubstepsPerStep = 1024; // How finely polygons along an axis are drawn.
        public const long PlacesPerSlope = 1 << 20; // As finely pyramids'.
        public const long MaxPlace = 1L << 31; // Of pyramids.

        public Grid3 Origin;
        public Grid3 U;
        public Grid3 V;
        public Grid3 W;

        public long MinU;
        public long MinV;
        public long MaxU;
        public long MaxV;

        public static EditPrism Empty => new EditPrism
        {
            MinU = long.MaxValue,
            MinV = long.MaxValue,
            MaxU = long.MinValue,
            MaxV = long.MinValue,
        };

        public readonly bool IsUsed => MaxU >= MinU;

        public readonly bool IsPyramid => W != default;

        public void Include(long u, long v)
        {
            (MinU, MaxU) = (math.min(MinU, u), math.max(MaxU, u));
            (MinV, MaxV) = (math.min(MinV, v), math.max(MaxV, v));
        }

        // Around what is seen of a box, a little larger than the polygons' bounds at most. False if nothing of it is.
        public readonly bool TryProject(in EditShape box, out EditEdge seen)
        {
            Grid3 low = box.A - Origin, high = box.B - Origin;
            seen = IsPyramid ? See(low, high) : new EditEdge
            {
                FromU = Dot(U, low, high).Clamp(MinU - 1, MaxU + 1),
                FromV = Dot(V, low, high).Clamp(MinV - 1, MaxV + 1),
                ToU = Dot(U, high, low).Clamp(MinU - 1, MaxU + 1),
                ToV = Dot(V, high, low).Clamp(MinV - 1, MaxV + 1),
            };
            return seen.ToU >= MinU && seen.FromU <= MaxU && seen.ToV >= MinV && seen.FromV <= MaxV;
        }

        // A box's places lie between those of its corners, if all are before the eye. If some are, they may be anywhere.
        readonly EditEdge See(Grid3 low, Grid3 high)
        {
            var seen = Empty;
            int corners = low == high ? 1 : 8, behind = 0;
            for (int i = 0; i < corners; i++)
            {
                var at = new Grid3((i & 1) == 0 ? low.X : high.X, (i & 2) == 0 ? low.Y : high.Y, (i & 4) == 0 ? low.Z : high.Z);
                var depth = Dot(W, at, at);
                if (depth.CompareTo(default) <= 0)
                    behind++;
                else
                    seen.Include(Dot(U, at, at).Times(PlacesPerSlope).Over(depth, MinU - 1, MaxU + 1),
                        Dot(V, at, at).Times(PlacesPerSlope).Over(depth, MinV - 1, MaxV + 1));
            }
            if (behind > 0 && behind < corners)
                (seen.MinU, seen.MinV, seen.MaxU, seen.MaxV) = (MinU - 1, MinV - 1, MaxU + 1, MaxV + 1);
            return new EditEdge { FromU = seen.MinU, FromV = seen.MinV, ToU = seen.MaxU, ToV = seen.MaxV };
        }

        static Signed128 Dot(Grid3 axis, Grid3 ofPositive, Grid3 ofNegative) =>
            Signed128.Product(axis.X, axis.X < 0 ? ofNegative.X : ofPositive.X) +
            Signed128.Product(axis.Y, axis.Y < 0 ? ofNegative.Y : ofPositive.Y) +
            Signed128.Product(axis.Z, axis.Z < 0 ? ofNegative.Z : ofPositive.Z);
    }

    internal unsafe struct EditEdge
    {
        public long FromU;
        public long FromV;
        public long ToU;
        public long ToV;
        public int Polygon; // Edges of one polygon have one number, and follow one another.

        // Whether it has to do with places in the box around another: crosses it, or lies to its right.
        public readonly bool MayMatterTo(in EditEdge box, out bool mayCross)
        {
            bool isInRow = math.max(FromV, ToV) >= box.FromV && math.min(FromV, ToV) <= box.ToV &&
                math.max(FromU, ToU) >= box.FromU;
            mayCross = isInRow && math.min(FromU, ToU) <= box.ToU;
            return isInRow;
        }

        // Whether any polygon holds a place: by an even-odd count of its edges, or on one.
        public static bool Hold(EditEdge* edges, int* near, int count, long u, long v)
        {
            int polygon = 0;
            bool isInside = false;
            var place = new EditEdge { FromU = u, ToU = u, FromV = v, ToV = v };
            for (int n = 0; n < count; n++)
            {
                ref var edge = ref edges[near[n]];
                if (edge.Polygon != polygon && isInside)
                    return true;
                polygon = edge.Polygon;
                if (!edge.MayMatterTo(place, out bool mayCross))
                    continue;
                long across = edge.ToU - edge.FromU, up = edge.ToV - edge.FromV;
                int side = Signed128.Product(across, v - edge.FromV).CompareTo(Signed128.Product(up, u - edge.FromU));
                if (side == 0 && mayCross)
                    return true;
                if (edge.FromV > v != edge.ToV > v && side > 0 == up > 0)
                    isInside = !isInside;
            }
            return isInside;
        }
    }

    // A whole number of 128 bits, for products of positions.
    internal readonly struct Signed128 : IComparable<Signed128>
    {
        readonly long m_high;
        readonly ulong m_low;

        Signed128(long high, ulong low) => (m_high, m_low) = (high, low);

        public static Signed128 Product(long a, long b)
        {
            ulong x = (ulong)a, y = (ulong)b, xLow = (uint)x, xHigh = x >> 32, yLow = (uint)y, yHigh = y >> 32;
            ulong low = xLow * yLow, between = xHigh * yLow + (low >> 32), other = xLow * yHigh + (uint)between;
            ulong high = xHigh * yHigh + (between >> 32) + (other >> 32);
            high -= (a < 0 ? y : 0) + (b < 0 ? x : 0);
            return new Signed128((long)high, other << 32 | (uint)low);
        }

        public static Signed128 operator +(Signed128 a, Signed128 b)
        {
            ulong low = a.m_low + b.m_low;
            return new Signed128(a.m_high + b.m_high + (low < a.m_low ? 1 : 0), low);
        }

        // Modulo 2^128.
        public Signed128 Times(long factor)
        {
            var low = Product((long)m_low, factor);
            return new Signed128(low.m_high + m_high * factor + ((long)m_low < 0 ? factor : 0), low.m_low);
        }

        // The quotient rounded down, or the end of the range that it lies beyond. The divisor is positive, and its product with
        // either end less than 2^127. The floating-point quotient is only where to begin.
        public long Over(Signed128 divisor, long min, long max)
        {
            long quotient = (long)math.floor(math.clamp(ToDouble() / divisor.ToDouble(), min, max));
            while (quotient > min && CompareTo(divisor.Times(quotient)) < 0)
                quotient--;
            while (quotient < max && CompareTo(divisor.Times(quotient + 1)) >= 0)
                quotient++;
            return quotient;
        }

        double ToDouble() => m_high * 18446744073709551616.0 + m_low;

        public int CompareTo(Signed128 other) =>
            m_high != other.m_high ? m_high.CompareTo(other.m_high) : m_low.CompareTo(other.m_low);

        public long Clamp(long min, long max) =>
            CompareTo(Product(min, 1)) <= 0 ? min : CompareTo(Product(max, 1)) >= 0 ? max : (long)m_low;
    }
}
