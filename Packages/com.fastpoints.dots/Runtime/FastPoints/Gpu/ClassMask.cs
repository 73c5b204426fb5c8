using System;
using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace FastPoints.Gpu
{
    /// <summary>Some of the 256 classes that points can have; none unless they are added. Blittable.</summary>
    public struct ClassMask : IEquatable<ClassMask>
    {
        /// <summary>Classes 0 to 127, 32 each, and 128 to 255.</summary>
        public uint4 Low;
        public uint4 High;

        public readonly bool IsEmpty => math.all((Low | High) == 0);

        /// <param name="classes">0 to 255 each; there are no others, and they are left out.</param>
        public static ClassMask Of(params int[] classes)
        {
            var mask = new ClassMask();
            foreach (int c in classes)
                if (c >= 0 && c <= byte.MaxValue)
                    mask.Add(c);
            return mask;
        }

        public void Add(int c)
        {
            if (c < 128)
                Low[c >> 5] |= 1u << (c & 31);
            else
                High[(c & 127) >> 5] |= 1u << (c & 31);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public readonly bool Has(int c) => ((c < 128 ? Low : High)[(c & 127) >> 5] >> (c & 31) & 1) != 0;

        public readonly bool Equals(ClassMask other) => math.all(Low == other.Low & High == other.High);

        /// <summary>All others.</summary>
        public readonly ClassMask Inverse => new ClassMask { Low = ~Low, High = ~High };
    }
}
