using System;

namespace UnityEngine
{
    public struct Hash128 : IEquatable<Hash128>
    {
        ulong m_low;
        ulong m_high;

        /// <summary>Another function than Unity's.</summary>
        public static Hash128 Compute(string data)
        {
            var hash = new Hash128 { m_low = 14695981039346656037, m_high = 1099511628211 };
            foreach (char c in data)
            {
                hash.m_low = (hash.m_low ^ c) * 1099511628211;
                hash.m_high = (hash.m_high + c) * 6364136223846793005;
            }
            return hash;
        }

        public readonly bool Equals(Hash128 obj) => m_low == obj.m_low && m_high == obj.m_high;

        public override readonly bool Equals(object obj) => obj is Hash128 other && Equals(other);

        public override readonly int GetHashCode() => HashCode.Combine(m_low, m_high);
    }
}
