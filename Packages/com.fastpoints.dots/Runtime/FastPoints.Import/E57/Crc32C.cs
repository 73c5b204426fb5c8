using System;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.E57
{
    // CRC-32C (Castagnoli, reflected polynomial 0x82F63B78, RFC 3720 B.4), eight bytes a step: Kounavis and Berry, "A systematic
    // approach to building high performance software-based CRC generators", 2005. Jobs share the tables.
    internal sealed unsafe class Crc32C : IDisposable
    {
        const uint Polynomial = 0x82F63B78;
        const int Tables = 8;

        NativeArray<uint> m_tables;

        public Crc32C(Allocator allocator)
        {
            m_tables = new NativeArray<uint>(Tables * 256, allocator);
            for (uint i = 0; i < 256; i++)
            {
                uint crc = i;
                for (int bit = 0; bit < 8; bit++)
                    crc = crc >> 1 ^ ((crc & 1) != 0 ? Polynomial : 0);
                m_tables[(int)i] = crc;
            }
            for (int i = 256; i < Tables * 256; i++)
                m_tables[i] = m_tables[i - 256] >> 8 ^ m_tables[(int)(m_tables[i - 256] & 255)];
        }

        public NativeArray<uint> Table => m_tables;

        public uint Of(byte[] bytes, int first, int count)
        {
            fixed (byte* p = bytes)
                return Compute((uint*)m_tables.GetUnsafeReadOnlyPtr(), p + first, count);
        }

        public static uint Compute(uint* tables, byte* bytes, int count)
        {
            uint crc = uint.MaxValue;
            int i = 0;
            for (; i + 8 <= count; i += 8)
            {
                ulong eight = *(ulong*)(bytes + i) ^ crc;
                crc = tables[7 * 256 + (byte)eight] ^ tables[6 * 256 + (byte)(eight >> 8)] ^
                    tables[5 * 256 + (byte)(eight >> 16)] ^ tables[4 * 256 + (byte)(eight >> 24)] ^
                    tables[3 * 256 + (byte)(eight >> 32)] ^ tables[2 * 256 + (byte)(eight >> 40)] ^
                    tables[256 + (byte)(eight >> 48)] ^ tables[eight >> 56];
            }
            for (; i < count; i++)
                crc = crc >> 8 ^ tables[(byte)(crc ^ bytes[i])];
            return ~crc;
        }

        public void Dispose()
        {
            if (m_tables.IsCreated)
                m_tables.Dispose();
        }
    }
}
