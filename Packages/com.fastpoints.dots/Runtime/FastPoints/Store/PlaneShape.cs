using System.Runtime.CompilerServices;

namespace FastPoints.Store
{
    /// <summary>What is the same for every block of a plane: how many columns, and which of them hold 64-bit values.</summary>
    /// <remarks>
    /// A plane of a node, as it lies on disk and in GPU memory, all in little-endian 32-bit words:
    /// <code>
    /// descriptor of block 0 | descriptor of block 1 | ... | packed words of block 0 | of block 1 | ... | zeros
    ///
    /// descriptor: word 0    first packed word of the block, counted from the plane's start
    ///             word 1    bits 0-7, 8-15, 16-23: bit widths of columns 0, 1, 2; bits 24-31: points - 1
    ///             then, for each column, its minimum: one word, or two (low, high) for a 64-bit column
    /// packed:     for each column in turn, ceil(points * width / 32) words: value i - minimum at bit i * width, lowest bit first
    /// </code>
    /// At least eight zero bytes follow the last packed word, and the length is a multiple of 16: a reader may load eight bytes
    /// from wherever a value begins.
    /// </remarks>
    public struct PlaneShape
    {
        /// <summary>Points of a full block. A full column takes 4 words for each bit of its width.</summary>
        public const int MaxPointsPerBlock = 128;

        /// <summary>The descriptor's second word has room for this many widths.</summary>
        public const int MaxColumns = 3;

        /// <summary>Number of zero bytes after the last packed word.</summary>
        public const int SlackBytes = 8;

        public const int AlignmentBytes = 16;

        public int ColumnCount;

        /// <summary>Bit c: column c holds 64-bit values.</summary>
        public int WideColumnMask;

        public PlaneShape(int columnCount, int wideColumnMask) => (ColumnCount, WideColumnMask) = (columnCount, wideColumnMask);

        // Wide positions need 64 bits on each axis.
        internal static PlaneShape OfPositions(bool areWide) => new PlaneShape(3, areWide ? 7 : 0);

        /// <summary>Words of one block's descriptor.</summary>
        public int DescriptorWords =>
            2 + ColumnCount + (WideColumnMask & 1) + (WideColumnMask >> 1 & 1) + (WideColumnMask >> 2 & 1);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public bool IsWide(int column) => (WideColumnMask >> column & 1) != 0;

        /// <summary>The word of a descriptor at which a column's minimum begins.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public int MinimumWord(int column)
        {
            int below = WideColumnMask & ((1 << column) - 1);
            return 2 + column + (below & 1) + (below >> 1 & 1);
        }

        /// <summary>Number of blocks for a node's points.</summary>
        public static int BlocksOf(int points) => (int)(((long)points + MaxPointsPerBlock - 1) / MaxPointsPerBlock);

        /// <summary>Packed words of a column.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static int WordsOf(int points, int width) => (points * width + 31) >> 5;

        /// <summary>Bytes of a plane, given the words of its descriptors and packed columns.</summary>
        public static long LengthBytes(long words) =>
            (words * 4 + SlackBytes + AlignmentBytes - 1) / AlignmentBytes * AlignmentBytes;

        /// <summary>Upper bound of a plane's length.</summary>
        public long MaxBytes(long blocks, long points)
        {
            long words = blocks * (DescriptorWords + ColumnCount);
            for (int c = 0; c < ColumnCount; c++)
                words += (points * (IsWide(c) ? 64 : 32) + 31) / 32;
            return LengthBytes(words);
        }
    }
}
