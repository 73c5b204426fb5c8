namespace UnityOutside.Images;

/// <summary>The checksums that PNG and zlib keep: CRC-32 (ISO 3309) of a chunk, Adler-32 (RFC 1950) of the pixels.</summary>
static class PngChecksums
{
    static readonly uint[] s_crcOfByte = MakeTable();

    static uint[] MakeTable()
    {
        var table = new uint[256];
        for (uint n = 0; n < table.Length; n++)
        {
            uint c = n;
            for (int bit = 0; bit < 8; bit++)
                c = (c & 1) != 0 ? 0xEDB88320u ^ c >> 1 : c >> 1;
            table[n] = c;
        }
        return table;
    }

    public static uint Crc32(byte[] bytes, int first, int count)
    {
        uint crc = 0xFFFFFFFFu;
        for (int i = first; i < first + count; i++)
            crc = s_crcOfByte[(byte)crc ^ bytes[i]] ^ crc >> 8;
        return ~crc;
    }

    /// <summary>The sums are reduced every 5,552 bytes: the most for which they cannot overflow 32 bits (zlib's
    /// NMAX).</summary>
    public static uint Adler32(byte[] bytes, int first, int count)
    {
        const uint Modulus = 65521;
        uint low = 1, high = 0;
        int end = first + count;
        for (int i = first; i < end;)
        {
            int stop = i + 5552 < end ? i + 5552 : end;
            for (; i < stop; i++)
            {
                low += bytes[i];
                high += low;
            }
            low %= Modulus;
            high %= Modulus;
        }
        return high << 16 | low;
    }
}
