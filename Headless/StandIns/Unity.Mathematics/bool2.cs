// A plain reading of Unity's signatures, one line a component.
using System;
using System.Diagnostics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace Unity.Mathematics
{
    public struct bool2 : IEquatable<bool2>
    {
        [MarshalAs(UnmanagedType.U1)] public bool x;
        [MarshalAs(UnmanagedType.U1)] public bool y;

        [MethodImpl(Inlining.Always)]
        public bool2(bool v)
        {
            this.x = v;
            this.y = v;
        }

        [MethodImpl(Inlining.Always)]
        public bool2(bool x, bool y)
        {
            this.x = x;
            this.y = y;
        }

        [MethodImpl(Inlining.Always)]
        public bool2(bool2 xy)
        {
            this.x = xy.x;
            this.y = xy.y;
        }

        [MethodImpl(Inlining.Always)]
        public static implicit operator bool2(bool v) => new bool2(v);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator &(bool lhs, bool2 rhs) => new bool2(lhs & rhs.x, lhs & rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator &(bool2 lhs, bool rhs) => new bool2(lhs.x & rhs, lhs.y & rhs);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator &(bool2 lhs, bool2 rhs) => new bool2(lhs.x & rhs.x, lhs.y & rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator |(bool lhs, bool2 rhs) => new bool2(lhs | rhs.x, lhs | rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator |(bool2 lhs, bool rhs) => new bool2(lhs.x | rhs, lhs.y | rhs);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator |(bool2 lhs, bool2 rhs) => new bool2(lhs.x | rhs.x, lhs.y | rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator ==(bool lhs, bool2 rhs) => new bool2(lhs == rhs.x, lhs == rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator ==(bool2 lhs, bool rhs) => new bool2(lhs.x == rhs, lhs.y == rhs);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator ==(bool2 lhs, bool2 rhs) => new bool2(lhs.x == rhs.x, lhs.y == rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator ^(bool lhs, bool2 rhs) => new bool2(lhs ^ rhs.x, lhs ^ rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator ^(bool2 lhs, bool rhs) => new bool2(lhs.x ^ rhs, lhs.y ^ rhs);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator ^(bool2 lhs, bool2 rhs) => new bool2(lhs.x ^ rhs.x, lhs.y ^ rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator !=(bool lhs, bool2 rhs) => new bool2(lhs != rhs.x, lhs != rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator !=(bool2 lhs, bool rhs) => new bool2(lhs.x != rhs, lhs.y != rhs);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator !=(bool2 lhs, bool2 rhs) => new bool2(lhs.x != rhs.x, lhs.y != rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator !(bool2 val) => new bool2(!val.x, !val.y);

        public unsafe bool this[int index]
        {
            [MethodImpl(Inlining.Always)]
            get
            {
                CheckIndex(index);
                fixed (bool* first = &x)
                    return first[index];
            }
            [MethodImpl(Inlining.Always)]
            set
            {
                CheckIndex(index);
                fixed (bool* first = &x)
                    first[index] = value;
            }
        }

        [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
        private static void CheckIndex(int index)
        {
            if ((uint)index >= 2)
                throw new ArgumentException("index must be between[0...1]");
        }

        [MethodImpl(Inlining.Always)]
        public bool Equals(bool2 rhs) => x == rhs.x && y == rhs.y;

        public override bool Equals(object o) => o is bool2 converted && Equals(converted);

        public override int GetHashCode() => (int)((x ? 0xFAAF07DDu : 0x90A285BBu) + (y ? 0x625C45BDu : 0x5D19E1D5u));

        public override string ToString() => $"bool2({x}, {y})";

        public bool2 xx
        {
            [MethodImpl(Inlining.Always)]
            get => new bool2(x, x);
        }

        public bool2 xy
        {
            [MethodImpl(Inlining.Always)]
            get => new bool2(x, y);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; y = value.y; }
        }

        public bool2 yx
        {
            [MethodImpl(Inlining.Always)]
            get => new bool2(y, x);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; x = value.y; }
        }

        public bool2 yy
        {
            [MethodImpl(Inlining.Always)]
            get => new bool2(y, y);
        }

        public bool3 xxx
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(x, x, x);
        }

        public bool3 yyy
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(y, y, y);
        }

        public bool4 xxxx
        {
            [MethodImpl(Inlining.Always)]
            get => new bool4(x, x, x, x);
        }

        public bool4 yyyy
        {
            [MethodImpl(Inlining.Always)]
            get => new bool4(y, y, y, y);
        }
    }
}
