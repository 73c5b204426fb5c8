using System;
using Unity.Mathematics;

namespace FastPoints.Store
{
    // How much of a box a shape holds, as far as its bounds say.
    internal enum EditReach
    {
        None,
        Some,
        All,
    }

    // Grid positions from one corner to another, both included.
    internal struct EditBox
    {
        public Grid3 Min;
        public Grid3 Max;

        // The positions of a grid whose coordinates lie in a box, faces included. What rounding alone puts outside counts as
        // inside, as in LocalClip.
        public static EditBox Of(in CloudGrid grid, double3 min, double3 max)
        {
            double3 low = (min - grid.Origin) / grid.Step, high = (max - grid.Origin) / grid.Step;
            var reach = (math.abs(min) + math.abs(max) + math.abs(grid.Origin)) * 4.5e-16 / grid.Step;
            return new EditBox { Min = GridOf(math.ceil(low - reach)), Max = GridOf(math.floor(high + reach)) };
        }

        public static Grid3 GridOf(double3 steps)
        {
            steps = math.clamp(steps, -EditOperation.MaxCoordinate, EditOperation.MaxCoordinate);
            return new Grid3((long)steps.x, (long)steps.y, (long)steps.z);
        }

        public readonly bool Holds(Grid3 p) => p.X >= Min.X && p.X <= Max.X && p.Y >= Min.Y && p.Y <= Max.Y && p.Z >= Min.Z &&
            p.Z <= Max.Z;

        public readonly EditReach ReachOf(in EditBox box) => Holds(box.Min) && Holds(box.Max) ? EditReach.All
            : box.Max.X < Min.X || box.Min.X > Max.X || box.Max.Y < Min.Y || box.Min.Y > Max.Y || box.Max.Z < Min.Z ||
                box.Min.Z > Max.Z ? EditReach.None : EditReach.Some;
    }

    // A ball, its surface included. Its radii in steps differ where a grid's steps do.
    internal struct EditBall
    {
        // Larger ones that differ would not fit the arithmetic.
        public const long MaxUnequalRadius = 1 << 20;

        public Grid3 Center;
        public Grid3 Radius;

        public readonly bool IsRound => Radius.X == Radius.Y && Radius.Y == Radius.Z;

        // The centre lies on the nearest grid position.
        public static EditBall Of(in CloudGrid grid, double3 center, double radius)
        {
            var ball = new EditBall
            {
                Center = EditBox.GridOf(math.round((center - grid.Origin) / grid.Step)),
                Radius = EditBox.GridOf(math.floor(radius / grid.Step * (1 + 4.5e-16))),
            };
            if (!ball.IsRound)
                ball.Radius = Grid3.Max(ball.Radius, new Grid3(1, 1, 1));
            return ball;
        }

        public readonly bool Holds(Grid3 p)
        {
            long x = p.X - Center.X, y = p.Y - Center.Y, z = p.Z - Center.Z;
            if (math.abs(x) > Radius.X || math.abs(y) > Radius.Y || math.abs(z) > Radius.Z)
                return false;
            if (!IsRound)
            {
                long yz = Radius.Y * Radius.Z, xz = Radius.X * Radius.Z, xy = Radius.X * Radius.Y;
                (x, y, z) = (x * yz, y * xz, z * xy);
                return Long2.Product(x, x) + Long2.Product(y, y) + Long2.Product(z, z) <=
                    Long2.Product(Radius.X * yz, Radius.X * yz);
            }
            if (Radius.X < 1 << 30)
                return x * x + y * y + z * z <= Radius.X * Radius.X;
            return Long2.Product(x, x) + Long2.Product(y, y) + Long2.Product(z, z) <= Long2.Product(Radius.X, Radius.X);
        }

        public readonly EditReach ReachOf(in EditBox box)
        {
            if (!Holds(Grid3.Min(Grid3.Max(Center, box.Min), box.Max)))
                return EditReach.None;
            var far = new Grid3(Farther(box.Min.X, box.Max.X, Center.X), Farther(box.Min.Y, box.Max.Y, Center.Y),
                Farther(box.Min.Z, box.Max.Z, Center.Z));
            return Holds(far) ? EditReach.All : EditReach.Some;
        }

        static long Farther(long a, long b, long from) => math.abs(a - from) > math.abs(b - from) ? a : b;
    }

    // Where polygons are drawn and what follows from them: a position is seen at u = dot(position - Origin, U), v likewise, so
    // that U and V say how finely, and from where: U x V is the axis along which the polygons reach without end.
    internal struct EditPrism
    {
        // How finely polygons along an axis are drawn.
        public const int PartsOfStep = 1024;

        public Grid3 Origin;
        public Grid3 U;
        public Grid3 V;

        // Of all vertices.
        public long MinU;
        public long MinV;
        public long MaxU;
        public long MaxV;

        public readonly bool IsUsed => MaxU >= MinU && MaxV >= MinV;

        public static EditPrism Empty => new EditPrism
        {
            MinU = long.MaxValue,
            MinV = long.MaxValue,
            MaxU = long.MinValue,
            MaxV = long.MinValue,
        };

        public void Include(long u, long v)
        {
            (MinU, MaxU) = (math.min(MinU, u), math.max(MaxU, u));
            (MinV, MaxV) = (math.min(MinV, v), math.max(MaxV, v));
        }

        // False outside of the polygons' bounds.
        public readonly bool TryProject(Grid3 position, out long u, out long v)
        {
            var from = position - Origin;
            u = Dot(U, from).Clamp(MinU - 1, MaxU + 1);
            v = Dot(V, from).Clamp(MinV - 1, MaxV + 1);
            return u >= MinU && u <= MaxU && v >= MinV && v <= MaxV;
        }

        // An edge box around what is seen of a box, a little larger than the polygons' bounds at most. False if nothing of it is.
        public readonly bool TryProject(in EditBox box, out EditEdge seen)
        {
            Grid3 low = box.Min - Origin, high = box.Max - Origin;
            seen = new EditEdge
            {
                FromU = Dot(U, Ends(U, low, high)).Clamp(MinU - 1, MaxU + 1),
                FromV = Dot(V, Ends(V, low, high)).Clamp(MinV - 1, MaxV + 1),
                ToU = Dot(U, Ends(U, high, low)).Clamp(MinU - 1, MaxU + 1),
                ToV = Dot(V, Ends(V, high, low)).Clamp(MinV - 1, MaxV + 1),
            };
            return seen.ToU >= MinU && seen.FromU <= MaxU && seen.ToV >= MinV && seen.FromV <= MaxV;
        }

        static Grid3 Ends(Grid3 axis, Grid3 ofPositive, Grid3 ofNegative) => new Grid3(axis.X < 0 ? ofNegative.X : ofPositive.X,
            axis.Y < 0 ? ofNegative.Y : ofPositive.Y, axis.Z < 0 ? ofNegative.Z : ofPositive.Z);

        static Long2 Dot(Grid3 a, Grid3 b) =>
            Long2.Product(a.X, b.X) + Long2.Product(a.Y, b.Y) + Long2.Product(a.Z, b.Z);
    }

    // An edge of a ring, in the prism's plane.
    internal unsafe struct EditEdge
    {
        public long FromU;
        public long FromV;
        public long ToU;
        public long ToV;

        // Edges of one polygon have one number, and follow one another.
        public int Polygon;

        // Whether it may cross or bound what lies in another one's box or, of those in rows with it, to the left of its end.
        public readonly bool MayMatterTo(in EditEdge box, bool isInRow) =>
            math.max(FromV, ToV) >= box.FromV && math.min(FromV, ToV) <= box.ToV && math.max(FromU, ToU) >= box.FromU &&
            (isInRow || math.min(FromU, ToU) <= box.ToU);

        // Whether any polygon holds a position: by an even-odd count of its edges, or on one.
        public static bool Hold(EditEdge* edges, int* near, int count, long u, long v)
        {
            int polygon = 0;
            bool isInside = false;
            for (int n = 0; n < count; n++)
            {
                ref var edge = ref edges[near[n]];
                if (edge.Polygon != polygon)
                {
                    if (isInside)
                        return true;
                    polygon = edge.Polygon;
                }
                if (math.max(edge.FromU, edge.ToU) < u || math.max(edge.FromV, edge.ToV) < v ||
                    math.min(edge.FromV, edge.ToV) > v)
                    continue;
                long across = edge.ToU - edge.FromU, up = edge.ToV - edge.FromV;
                int side = Long2.Product(across, v - edge.FromV).CompareTo(Long2.Product(up, u - edge.FromU));
                if (side == 0 && u >= math.min(edge.FromU, edge.ToU))
                    return true;
                if (edge.FromV > v != edge.ToV > v && side > 0 == up > 0)
                    isInside = !isInside;
            }
            return isInside;
        }
    }

    // A whole number of 128 bits, for products of positions.
    internal readonly struct Long2 : IComparable<Long2>
    {
        readonly long m_high;
        readonly ulong m_low;

        Long2(long high, ulong low) => (m_high, m_low) = (high, low);

        public static Long2 Product(long a, long b)
        {
            ulong x = (ulong)a, y = (ulong)b, xLow = (uint)x, xHigh = x >> 32, yLow = (uint)y, yHigh = y >> 32;
            ulong low = xLow * yLow, between = xHigh * yLow + (low >> 32), other = xLow * yHigh + (uint)between;
            ulong high = xHigh * yHigh + (between >> 32) + (other >> 32);
            high -= (a < 0 ? y : 0) + (b < 0 ? x : 0);
            return new Long2((long)high, other << 32 | (uint)low);
        }

        public static Long2 operator +(Long2 a, Long2 b)
        {
            ulong low = a.m_low + b.m_low;
            return new Long2(a.m_high + b.m_high + (low < a.m_low ? 1 : 0), low);
        }

        public static bool operator <=(Long2 a, Long2 b) => a.CompareTo(b) <= 0;

        public static bool operator >=(Long2 a, Long2 b) => a.CompareTo(b) >= 0;

        public int CompareTo(Long2 other) => m_high != other.m_high ? m_high < other.m_high ? -1 : 1
            : m_low != other.m_low ? m_low < other.m_low ? -1 : 1 : 0;

        public long Clamp(long min, long max) => this <= Product(min, 1) ? min : this >= Product(max, 1) ? max : (long)m_low;
    }
}
