// A plain reading of Unity's signatures, one line a component.
using System;
using System.Diagnostics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace Unity.Mathematics
{
    public struct bool3 : IEquatable<bool3>
    {
        [MarshalAs(UnmanagedType.U1)] public bool x;
        [MarshalAs(UnmanagedType.U1)] public bool y;
        [MarshalAs(UnmanagedType.U1)] public bool z;

        [MethodImpl(Inlining.Always)]
        public bool3(bool v)
        {
            this.x = v;
            this.y = v;
            this.z = v;
        }

        [MethodImpl(Inlining.Always)]
        public bool3(bool x, bool y, bool z)
        {
            this.x = x;
            this.y = y;
            this.z = z;
        }

        [MethodImpl(Inlining.Always)]
        public bool3(bool x, bool2 yz)
        {
            this.x = x;
            this.y = yz.x;
            this.z = yz.y;
        }

        [MethodImpl(Inlining.Always)]
        public bool3(bool2 xy, bool z)
        {
            this.x = xy.x;
            this.y = xy.y;
            this.z = z;
        }

        [MethodImpl(Inlining.Always)]
        public bool3(bool3 xyz)
        {
            this.x = xyz.x;
            this.y = xyz.y;
            this.z = xyz.z;
        }

        [MethodImpl(Inlining.Always)]
        public static implicit operator bool3(bool v) => new bool3(v);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator &(bool lhs, bool3 rhs) => new bool3(lhs & rhs.x, lhs & rhs.y, lhs & rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator &(bool3 lhs, bool rhs) => new bool3(lhs.x & rhs, lhs.y & rhs, lhs.z & rhs);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator &(bool3 lhs, bool3 rhs) => new bool3(lhs.x & rhs.x, lhs.y & rhs.y, lhs.z & rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator |(bool lhs, bool3 rhs) => new bool3(lhs | rhs.x, lhs | rhs.y, lhs | rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator |(bool3 lhs, bool rhs) => new bool3(lhs.x | rhs, lhs.y | rhs, lhs.z | rhs);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator |(bool3 lhs, bool3 rhs) => new bool3(lhs.x | rhs.x, lhs.y | rhs.y, lhs.z | rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator ==(bool lhs, bool3 rhs) => new bool3(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator ==(bool3 lhs, bool rhs) => new bool3(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator ==(bool3 lhs, bool3 rhs) => new bool3(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator ^(bool lhs, bool3 rhs) => new bool3(lhs ^ rhs.x, lhs ^ rhs.y, lhs ^ rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator ^(bool3 lhs, bool rhs) => new bool3(lhs.x ^ rhs, lhs.y ^ rhs, lhs.z ^ rhs);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator ^(bool3 lhs, bool3 rhs) => new bool3(lhs.x ^ rhs.x, lhs.y ^ rhs.y, lhs.z ^ rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator !=(bool lhs, bool3 rhs) => new bool3(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator !=(bool3 lhs, bool rhs) => new bool3(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator !=(bool3 lhs, bool3 rhs) => new bool3(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator !(bool3 val) => new bool3(!val.x, !val.y, !val.z);

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
            if ((uint)index >= 3)
                throw new ArgumentException("index must be between[0...2]");
        }

        [MethodImpl(Inlining.Always)]
        public bool Equals(bool3 rhs) => x == rhs.x && y == rhs.y && z == rhs.z;

        public override bool Equals(object o) => o is bool3 converted && Equals(converted);

        public override int GetHashCode() => (int)(
            (x ? 0xAF816615u : 0xA1E92D39u) + (y ? 0x9AF8D62Du : 0x4583C801u) + (z ? 0xE3600729u : 0x9536A0F5u));

        public override string ToString() => $"bool3({x}, {y}, {z})";

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

        public bool2 xz
        {
            [MethodImpl(Inlining.Always)]
            get => new bool2(x, z);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; z = value.y; }
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

        public bool2 yz
        {
            [MethodImpl(Inlining.Always)]
            get => new bool2(y, z);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; z = value.y; }
        }

        public bool2 zx
        {
            [MethodImpl(Inlining.Always)]
            get => new bool2(z, x);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; x = value.y; }
        }

        public bool2 zy
        {
            [MethodImpl(Inlining.Always)]
            get => new bool2(z, y);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; y = value.y; }
        }

        public bool2 zz
        {
            [MethodImpl(Inlining.Always)]
            get => new bool2(z, z);
        }

        public bool3 xxx
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(x, x, x);
        }

        public bool3 xyz
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(x, y, z);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; y = value.y; z = value.z; }
        }

        public bool3 xzy
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(x, z, y);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; z = value.y; y = value.z; }
        }

        public bool3 yxz
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(y, x, z);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; x = value.y; z = value.z; }
        }

        public bool3 yyy
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(y, y, y);
        }

        public bool3 yzx
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(y, z, x);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; z = value.y; x = value.z; }
        }

        public bool3 zxy
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(z, x, y);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; x = value.y; y = value.z; }
        }

        public bool3 zyx
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(z, y, x);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; y = value.y; x = value.z; }
        }

        public bool3 zzz
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(z, z, z);
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

        public bool4 zzzz
        {
            [MethodImpl(Inlining.Always)]
            get => new bool4(z, z, z, z);
        }
    }
}
