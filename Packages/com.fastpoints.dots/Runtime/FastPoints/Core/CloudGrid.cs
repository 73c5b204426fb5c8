using System;
using Unity.Mathematics;

namespace FastPoints
{
    /// <summary>The one grid that all points of a cloud lie on: geo = Origin + Step * grid, in double, in CRS units.</summary>
    public struct CloudGrid
    {
        public double3 Origin;

        /// <summary>Positive on each axis.</summary>
        public double3 Step;

        public double3 ToGeo(Grid3 position) => new double3(position.X, position.Y, position.Z) * Step + Origin;

        /// <summary>For offsets from a corner of the grid. Rounds once more than ToGeo: for pictures, not for proofs.</summary>
        public PositionTransform TransformFromCorner(Grid3 corner) =>
            new PositionTransform { Scale = Step, Offset = ToGeo(corner) };
    }

    /// <summary>A position on a cloud's grid in whole steps: exact at any distance from the origin.</summary>
    public struct Grid3 : IEquatable<Grid3>
    {
        public long X;
        public long Y;
        public long Z;

        public Grid3(long x, long y, long z) => (X, Y, Z) = (x, y, z);

        internal static Grid3 MinValue => new Grid3(long.MinValue, long.MinValue, long.MinValue);
        internal static Grid3 MaxValue => new Grid3(long.MaxValue, long.MaxValue, long.MaxValue);

        public static Grid3 operator +(Grid3 a, Grid3 b) => new Grid3(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

        public static Grid3 operator -(Grid3 a, Grid3 b) => new Grid3(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

        public static bool operator ==(Grid3 a, Grid3 b) => a.X == b.X && a.Y == b.Y && a.Z == b.Z;

        public static bool operator !=(Grid3 a, Grid3 b) => !(a == b);

        public static Grid3 Min(Grid3 a, Grid3 b) => new Grid3(math.min(a.X, b.X), math.min(a.Y, b.Y), math.min(a.Z, b.Z));

        public static Grid3 Max(Grid3 a, Grid3 b) => new Grid3(math.max(a.X, b.X), math.max(a.Y, b.Y), math.max(a.Z, b.Z));

        public bool Equals(Grid3 other) => this == other;

        public override bool Equals(object obj) => obj is Grid3 other && this == other;

        public override int GetHashCode() => (X * 73856093 ^ Y * 19349663 ^ Z * 83492791).GetHashCode();

        public override string ToString() => NumberText.Of(X) + ", " + NumberText.Of(Y) + ", " + NumberText.Of(Z);
    }

    /// <summary>A cube on a cloud's grid: all positions from its corner to less than a power-of-two side beyond it. Sides end
    /// at 2^62, so that sums of corners and sides stay within a long.</summary>
    public struct GridCube
    {
        /// <summary>Larger sides are refused.</summary>
        public const int MaxSideLog2 = 62;

        public Grid3 Corner;
        public int SideLog2;

        public GridCube(Grid3 corner, int sideLog2) => (Corner, SideLog2) = (corner, sideLog2);

        /// <summary>Grid steps along an edge.</summary>
        public long Side => 1L << SideLog2;

        public bool Contains(Grid3 position) =>
            (ulong)(position.X - Corner.X) >> SideLog2 == 0 && (ulong)(position.Y - Corner.Y) >> SideLog2 == 0 &&
            (ulong)(position.Z - Corner.Z) >> SideLog2 == 0;

        /// <param name="other">Of the same octree.</param>
        public bool ContainsAligned(GridCube other) => other.SideLog2 <= SideLog2 && Contains(other.Corner);

        /// <summary>One of the eight cubes of half the side: bit 0 of the octant is x, bit 1 y, bit 2 z.</summary>
        public GridCube Child(int octant)
        {
            long half = 1L << (SideLog2 - 1);
            return new GridCube(
                Corner + new Grid3((octant & 1) * half, (octant >> 1 & 1) * half, (octant >> 2 & 1) * half), SideLog2 - 1);
        }

        /// <summary>The octant of a position inside.</summary>
        public int OctantOf(Grid3 position)
        {
            int bit = SideLog2 - 1;
            return (int)((position.X - Corner.X) >> bit & 1) | (int)((position.Y - Corner.Y) >> bit & 1) << 1 |
                (int)((position.Z - Corner.Z) >> bit & 1) << 2;
        }

        public override string ToString() => "(" + Corner + ") + 2^" + SideLog2;
    }

    // Maps grid positions to a cloud's own space: CRS units from the corner of the root cube.
    internal struct CloudLocalSpace
    {
        public Grid3 Corner;
        public double3 Step;
        public int RootSideLog2;
        public Grid3 BoundsMin;
        public Grid3 BoundsMax;
        public ulong CloudId;

        public double3 ToLocal(Grid3 position)
        {
            var from = position - Corner;
            return new double3(from.X, from.Y, from.Z) * Step;
        }

        // Of the points that lie in a cube.
        public void BoxOf(in GridCube cube, out double3 center, out float3 half)
        {
            long last = cube.Side - 1;
            var max = Grid3.Min(cube.Corner + new Grid3(last, last, last), BoundsMax);
            Box(Grid3.Max(cube.Corner, BoundsMin), max, out center, out half);
        }

        // Both ends are included; rounded outwards.
        public void Box(Grid3 min, Grid3 max, out double3 center, out float3 half) =>
            Box(ToLocal(min), ToLocal(max), out center, out half);

        public static void Box(double3 min, double3 max, out double3 center, out float3 half)
        {
            center = (min + max) * 0.5;
            // The last digit of a float is 1.2e-7 of its value; the centre's rounding in double is far smaller.
            half = (float3)((max - min) * (0.5 * (1 + 2.4e-7)));
        }
    }
}
