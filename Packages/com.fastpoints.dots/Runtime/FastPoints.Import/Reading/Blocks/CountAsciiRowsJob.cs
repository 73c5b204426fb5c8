using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Reading
{
    [BurstCompile]
    unsafe struct CountAsciiRowsJob : IJob
    {
        const ulong Ones = 0x0101010101010101;
        const ulong Highs = 0x8080808080808080;

        [ReadOnly] public NativeArray<byte> Input;
        public int Bytes;
        [WriteOnly] public NativeReference<AsciiRowCount> Result;

        public void Execute()
        {
            byte* p = (byte*)Input.GetUnsafeReadOnlyPtr();
            byte* end = p + Bytes;
            var count = default(AsciiRowCount);
            bool isInText = false;

            while (p < end && !AsciiLines.IsLineEnd(*p))
                isInText |= *p++ > ' ';
            count.HasTextBeforeFirstEnd = isInText;
            count.HasLineEnd = p < end;
            int rows = 0;
            if (count.HasLineEnd)
                isInText = false;
            while (p < end)
            {
                // Within a line only its end matters, so eight bytes are tested at a time. The test for "any byte equal" is
                // exact.
                if (isInText)
                {
                    while (end - p >= 8)
                    {
                        ulong word = *(ulong*)p;
                        ulong lf = word ^ Ones * '\n', cr = word ^ Ones * '\r';
                        if (((((lf - Ones) & ~lf) | ((cr - Ones) & ~cr)) & Highs) != 0)
                            break;
                        p += 8;
                    }
                    while (p < end && !AsciiLines.IsLineEnd(*p))
                        p++;
                    isInText = p == end;
                }
                else if (*p++ > ' ')
                {
                    rows++;
                    isInText = true;
                }
            }
            count.RowsBehindFirstEnd = rows;
            count.EndsInText = isInText;
            Result.Value = count;
        }
    }

    // Counted without knowing whether the segment starts within a line. Blank lines do not count.
    struct AsciiRowCount
    {
        // Lines whose first character lies in the segment, behind its first line end.
        public int RowsBehindFirstEnd;

        // A line of this segment unless it started earlier.
        public bool HasTextBeforeFirstEnd;

        public bool HasLineEnd;

        // The next segment starts within a line.
        public bool EndsInText;
    }
}
