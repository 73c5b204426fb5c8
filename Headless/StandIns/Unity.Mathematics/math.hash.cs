namespace Unity.Mathematics
{
    public static partial class math
    {
        private const uint Prime1 = 2654435761u;
        private const uint Prime2 = 2246822519u;
        private const uint Prime3 = 3266489917u;
        private const uint Prime4 = 668265263u;
        private const uint Prime5 = 374761393u;

        internal static uint fold_to_uint(double x)
        {
            ulong bits = asulong(x);
            return (uint)(bits >> 32) ^ (uint)bits;
        }

        /// <summary>xxHash32 of a range of bytes.</summary>
        public static unsafe uint hash(void* pBuffer, int numBytes, uint seed = 0)
        {
            byte* at = (byte*)pBuffer;
            byte* end = at + numBytes;
            uint h;
            if (numBytes >= 16)
            {
                uint a = seed + Prime1 + Prime2;
                uint b = seed + Prime2;
                uint c = seed;
                uint d = seed - Prime1;
                for (; end - at >= 16; at += 16)
                {
                    a = rol(a + ((uint*)at)[0] * Prime2, 13) * Prime1;
                    b = rol(b + ((uint*)at)[1] * Prime2, 13) * Prime1;
                    c = rol(c + ((uint*)at)[2] * Prime2, 13) * Prime1;
                    d = rol(d + ((uint*)at)[3] * Prime2, 13) * Prime1;
                }
                h = rol(a, 1) + rol(b, 7) + rol(c, 12) + rol(d, 18);
            }
            else
            {
                h = seed + Prime5;
            }
            h += (uint)numBytes;
            for (; end - at >= 4; at += 4)
                h = rol(h + *(uint*)at * Prime3, 17) * Prime4;
            for (; at < end; at++)
                h = rol(h + *at * Prime5, 11) * Prime1;
            h = (h ^ (h >> 15)) * Prime2;
            h = (h ^ (h >> 13)) * Prime3;
            return h ^ (h >> 16);
        }
    }
}
