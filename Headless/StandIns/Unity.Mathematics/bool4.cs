// A plain reading of Unity's signatures, one line a component.
using System;
using System.Diagnostics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace Unity.Mathematics
{
    public struct bool4 : IEquatable<bool4>
    {
        [MarshalAs(UnmanagedType.U1)] public bool x;
        [MarshalAs(UnmanagedType.U1)] public bool y;
        [MarshalAs(UnmanagedType.U1)] public bool z;
        [MarshalAs(UnmanagedType.U1)] public bool w;

        [MethodImpl(Inlining.Always)]
        public bool4(bool v)
        {
            this.x = v;
            this.y = v;
            this.z = v;
            this.w = v;
        }

        [MethodImpl(Inlining.Always)]
        public bool4(bool x, bool y, bool z, bool w)
        {
            this.x = x;
            this.y = y;
            this.z = z;
            this.w = w;
        }

        [MethodImpl(Inlining.Always)]
        public bool4(bool x, bool y, bool2 zw)
        {
            this.x = x;
            this.y = y;
            this.z = zw.x;
            this.w = zw.y;
        }

        [MethodImpl(Inlining.Always)]
        public bool4(bool x, bool2 yz, bool w)
        {
            this.x = x;
            this.y = yz.x;
            this.z = yz.y;
            this.w = w;
        }

        [MethodImpl(Inlining.Always)]
        public bool4(bool x, bool3 yzw)
        {
            this.x = x;
            this.y = yzw.x;
            this.z = yzw.y;
            this.w = yzw.z;
        }

        [MethodImpl(Inlining.Always)]
        public bool4(bool2 xy, bool z, bool w)
        {
            this.x = xy.x;
            this.y = xy.y;
            this.z = z;
            this.w = w;
        }

        [MethodImpl(Inlining.Always)]
        public bool4(bool2 xy, bool2 zw)
        {
            this.x = xy.x;
            this.y = xy.y;
            this.z = zw.x;
            this.w = zw.y;
        }

        [MethodImpl(Inlining.Always)]
        public bool4(bool3 xyz, bool w)
        {
            this.x = xyz.x;
            this.y = xyz.y;
            this.z = xyz.z;
            this.w = w;
        }

        [MethodImpl(Inlining.Always)]
        public bool4(bool4 xyzw)
        {
            this.x = xyzw.x;
            this.y = xyzw.y;
            this.z = xyzw.z;
            this.w = xyzw.w;
        }

        [MethodImpl(Inlining.Always)]
        public static implicit operator bool4(bool v) => new bool4(v);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator &(bool lhs, bool4 rhs) => new bool4(lhs & rhs.x, lhs & rhs.y, lhs & rhs.z, lhs & rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator &(bool4 lhs, bool rhs) => new bool4(lhs.x & rhs, lhs.y & rhs, lhs.z & rhs, lhs.w & rhs);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator &(bool4 lhs, bool4 rhs) => new bool4(lhs.x & rhs.x, lhs.y & rhs.y, lhs.z & rhs.z, lhs.w & rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator |(bool lhs, bool4 rhs) => new bool4(lhs | rhs.x, lhs | rhs.y, lhs | rhs.z, lhs | rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator |(bool4 lhs, bool rhs) => new bool4(lhs.x | rhs, lhs.y | rhs, lhs.z | rhs, lhs.w | rhs);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator |(bool4 lhs, bool4 rhs) => new bool4(lhs.x | rhs.x, lhs.y | rhs.y, lhs.z | rhs.z, lhs.w | rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator ==(bool lhs, bool4 rhs) => new bool4(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z, lhs == rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator ==(bool4 lhs, bool rhs) => new bool4(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs, lhs.w == rhs);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator ==(bool4 lhs, bool4 rhs) => new bool4(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z, lhs.w == rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator ^(bool lhs, bool4 rhs) => new bool4(lhs ^ rhs.x, lhs ^ rhs.y, lhs ^ rhs.z, lhs ^ rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator ^(bool4 lhs, bool rhs) => new bool4(lhs.x ^ rhs, lhs.y ^ rhs, lhs.z ^ rhs, lhs.w ^ rhs);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator ^(bool4 lhs, bool4 rhs) => new bool4(lhs.x ^ rhs.x, lhs.y ^ rhs.y, lhs.z ^ rhs.z, lhs.w ^ rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator !=(bool lhs, bool4 rhs) => new bool4(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z, lhs != rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator !=(bool4 lhs, bool rhs) => new bool4(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs, lhs.w != rhs);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator !=(bool4 lhs, bool4 rhs) => new bool4(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z, lhs.w != rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator !(bool4 val) => new bool4(!val.x, !val.y, !val.z, !val.w);

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
            if ((uint)index >= 4)
                throw new ArgumentException("index must be between[0...3]");
        }

        [MethodImpl(Inlining.Always)]
        public bool Equals(bool4 rhs) => x == rhs.x && y == rhs.y && z == rhs.z && w == rhs.w;

        public override bool Equals(object o) => o is bool4 converted && Equals(converted);

        public override int GetHashCode() => (int)(
            (x ? 0xC53F4755u : 0x5FFF6B19u) + (y ? 0x6985C229u : 0x5E6CBF3Bu) +
            (z ? 0xE133B0B3u : 0xB546F2A5u) + (w ? 0xC3E0A3B9u : 0xBBCF63E7u));

        public override string ToString() => $"bool4({x}, {y}, {z}, {w})";

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

        public bool2 xw
        {
            [MethodImpl(Inlining.Always)]
            get => new bool2(x, w);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; w = value.y; }
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

        public bool2 yw
        {
            [MethodImpl(Inlining.Always)]
            get => new bool2(y, w);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; w = value.y; }
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

        public bool2 zw
        {
            [MethodImpl(Inlining.Always)]
            get => new bool2(z, w);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; w = value.y; }
        }

        public bool2 wx
        {
            [MethodImpl(Inlining.Always)]
            get => new bool2(w, x);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; x = value.y; }
        }

        public bool2 wy
        {
            [MethodImpl(Inlining.Always)]
            get => new bool2(w, y);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; y = value.y; }
        }

        public bool2 wz
        {
            [MethodImpl(Inlining.Always)]
            get => new bool2(w, z);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; z = value.y; }
        }

        public bool2 ww
        {
            [MethodImpl(Inlining.Always)]
            get => new bool2(w, w);
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

        public bool3 xyw
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(x, y, w);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; y = value.y; w = value.z; }
        }

        public bool3 xzy
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(x, z, y);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; z = value.y; y = value.z; }
        }

        public bool3 xzw
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(x, z, w);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; z = value.y; w = value.z; }
        }

        public bool3 xwy
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(x, w, y);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; w = value.y; y = value.z; }
        }

        public bool3 xwz
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(x, w, z);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; w = value.y; z = value.z; }
        }

        public bool3 yxz
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(y, x, z);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; x = value.y; z = value.z; }
        }

        public bool3 yxw
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(y, x, w);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; x = value.y; w = value.z; }
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

        public bool3 yzw
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(y, z, w);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; z = value.y; w = value.z; }
        }

        public bool3 ywx
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(y, w, x);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; w = value.y; x = value.z; }
        }

        public bool3 ywz
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(y, w, z);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; w = value.y; z = value.z; }
        }

        public bool3 zxy
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(z, x, y);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; x = value.y; y = value.z; }
        }

        public bool3 zxw
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(z, x, w);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; x = value.y; w = value.z; }
        }

        public bool3 zyx
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(z, y, x);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; y = value.y; x = value.z; }
        }

        public bool3 zyw
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(z, y, w);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; y = value.y; w = value.z; }
        }

        public bool3 zzz
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(z, z, z);
        }

        public bool3 zwx
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(z, w, x);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; w = value.y; x = value.z; }
        }

        public bool3 zwy
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(z, w, y);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; w = value.y; y = value.z; }
        }

        public bool3 wxy
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(w, x, y);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; x = value.y; y = value.z; }
        }

        public bool3 wxz
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(w, x, z);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; x = value.y; z = value.z; }
        }

        public bool3 wyx
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(w, y, x);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; y = value.y; x = value.z; }
        }

        public bool3 wyz
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(w, y, z);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; y = value.y; z = value.z; }
        }

        public bool3 wzx
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(w, z, x);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; z = value.y; x = value.z; }
        }

        public bool3 wzy
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(w, z, y);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; z = value.y; y = value.z; }
        }

        public bool3 www
        {
            [MethodImpl(Inlining.Always)]
            get => new bool3(w, w, w);
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

        public bool4 wwww
        {
            [MethodImpl(Inlining.Always)]
            get => new bool4(w, w, w, w);
        }
    }
}
