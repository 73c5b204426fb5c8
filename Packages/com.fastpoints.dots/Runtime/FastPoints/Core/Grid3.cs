using System;
using Unity.Mathematics;

namespace FastPoints.Core
{
    /// <summary>A position on a cloud's grid in whole steps: exact at any distance from the origin.</summary>
    public struct Grid3 : IEquatable<Grid3>
    {
        public long X;
        public long Y;
        public long Z;

        public Grid3(long x, long y, long z)
        {
            X = x;
            Y = y;
            Z = z;
        }

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
}
