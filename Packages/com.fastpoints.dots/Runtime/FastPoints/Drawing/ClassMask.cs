using System;
using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace FastPoints.Drawing
{
    /// <summary>A set of the 256 classes that points can have; empty by default. Blittable.</summary>
    public struct ClassMask : IEquatable<ClassMask>
    {
        /// <summary>Classes 0 to 127, 32 each, and 128 to 255.</summary>
        public uint4 Low;
        public uint4 High;

        public readonly bool IsEmpty => math.all((Low | High) == 0);

        /// <param name="classes">Numbers from 0 to 255; others do not exist and are ignored.</param>
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

        /// <summary>The complement.</summary>
        public readonly ClassMask Inverse => new ClassMask { Low = ~Low, High = ~High };
    }
}
