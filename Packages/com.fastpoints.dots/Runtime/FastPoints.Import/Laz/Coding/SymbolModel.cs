using System.Runtime.CompilerServices;

namespace FastPoints.Laz
{
    /// <summary>An adaptive model of an alphabet of up to 1,024 symbols: a header in front of its tables, all in one piece of
    /// native memory without pointers, so that a decoder's state can be copied as bytes. HPC#.</summary>
    /// <remarks><code>
    /// byte   0  header (this struct)
    ///       16  ushort Distribution[capacity + 1]  where each symbol's interval starts, of 32,768; 65,535 behind the last
    ///           ushort Count[capacity]             how often each symbol came
    ///           ushort FirstSymbol[cells + 1]      for each cell of the 32,768, a symbol at or before the one that lies there
    /// </code>
    /// Cells: about four a symbol, at most 256, so that the scan from a cell's first symbol mostly stops at once. A model
    /// may use fewer symbols than its memory has capacity for. Its numbers follow LASzip's exactly: they are the format.
    /// </remarks>
    internal unsafe struct SymbolModel
    {
        public const int HeaderBytes = 16;
        public const int LengthBits = 15;
        const int MaxTotal = 1 << LengthBits;

        // BytesOf these capacities, as constants for the places of models within a decoder's state.
        public const int Bytes4 = 128;
        public const int Bytes6 = 128;
        public const int Bytes9 = 128;
        public const int Bytes13 = 192;
        public const int Bytes16 = 256;
        public const int Bytes17 = 256;
        public const int Bytes33 = 448;
        public const int Bytes64 = 832;
        public const int Bytes128 = 1088;
        public const int Bytes256 = 1600;
        public const int Bytes512 = 2624;
        public const int Bytes516 = 2624;

        ushort m_untilUpdate;
        ushort m_cycle;
        ushort m_lastSymbol;
        ushort m_cellShift;
        ushort m_capacity;
        uint m_total;

        /// <summary>Bytes of a model for this many symbols, a multiple of a cache line.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static int BytesOf(int capacity) =>
            (HeaderBytes + (capacity + 1) * 2 + capacity * 2 + ((1 << CellBits(capacity)) + 1) * 2 + 63) / 64 * 64;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static int CellBits(int symbols) =>
            symbols >= 64 ? 8 : symbols >= 32 ? 7 : symbols >= 16 ? 6 : symbols >= 8 ? 5 : symbols >= 4 ? 4 : 3;

        public static void Initialize(SymbolModel* model, int symbols, int capacity)
        {
            model->m_lastSymbol = (ushort)(symbols - 1);
            model->m_cellShift = (ushort)(LengthBits - CellBits(symbols));
            model->m_capacity = (ushort)capacity;
            model->m_total = 0;
            model->m_cycle = (ushort)symbols;
            ushort* count = Counts(model, capacity);
            for (int i = 0; i < symbols; i++)
                count[i] = 1;
            Distribution(model)[symbols] = ushort.MaxValue;
            Update(model);
            model->m_cycle = (ushort)((symbols + 6) >> 1);
            model->m_untilUpdate = model->m_cycle;
        }

        public static void Initialize(byte* model, int symbols) => Initialize((SymbolModel*)model, symbols, symbols);

        /// <summary>The next symbol. <paramref name="capacity"/> is that of its memory; a constant where speed matters.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static uint Decode(byte* memory, int capacity, ref uint value, ref uint length, ref byte* next)
        {
            var model = (SymbolModel*)memory;
            ushort* starts = Distribution(model);
            uint unit = length >> LengthBits;
            uint at = value / unit;
            uint symbol = FirstSymbols(model, capacity)[at >> model->m_cellShift];
            while (starts[symbol + 1] <= at)
                symbol++;

            uint low = starts[symbol] * unit;
            // The last symbol also gets what the division by 32,768 leaves over.
            uint high = length;
            if (symbol != model->m_lastSymbol)
                high = starts[symbol + 1] * unit;
            value -= low;
            length = high - low;
            RangeCoder.Renormalize(ref value, ref length, ref next);

            Counts(model, capacity)[symbol]++;
            if (--model->m_untilUpdate == 0)
                Update(model);
            return symbol;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void Encode(byte* memory, int capacity, uint symbol, ref uint low, ref uint length, ref byte* next)
        {
            var model = (SymbolModel*)memory;
            ushort* starts = Distribution(model);
            uint unit = length >> LengthBits;
            // The entry after the last symbol is 65,535, whose top bit marks it: the mask makes it 32,768, and the last symbol
            // also gets the division's remainder.
            uint start = starts[symbol], end = starts[symbol + 1], isLast = end >> LengthBits;
            end &= MaxTotal - 1 + isLast;
            RangeCoder.Narrow(start * unit, (end - start) * unit + (length & MaxTotal - 1 & 0 - isLast), ref low, ref length,
                ref next);
            Counts(model, capacity)[symbol]++;
            if (--model->m_untilUpdate == 0)
                UpdateStarts(model);
        }

        /// <summary>Derives the distribution from the counts, and what finds symbols in it.</summary>
        [MethodImpl(MethodImplOptions.NoInlining)]
        static void Update(SymbolModel* model)
        {
            int symbols = model->m_lastSymbol + 1;
            ushort* starts = Distribution(model);
            ushort* count = Counts(model, model->m_capacity);
            ushort* first = FirstSymbols(model, model->m_capacity);
            uint scale = RescaleCounts(model);
            int shift = model->m_cellShift;
            uint sum = 0;
            int cell = 0;
            starts[0] = 0;
            for (int i = 0; i < symbols - 1; i++)
            {
                sum += count[i];
                uint end = (scale * sum) >> (31 - LengthBits);
                starts[i + 1] = (ushort)end;
                int lastCell = (int)(end >> shift);
                while (cell <= lastCell)
                    first[cell++] = (ushort)i;
            }
            int cells = 1 << (LengthBits - shift);
            while (cell <= cells)
                first[cell++] = (ushort)(symbols - 1);
        }

        /// <summary>The distribution alone: encoders do not look symbols up.</summary>
        [MethodImpl(MethodImplOptions.NoInlining)]
        static void UpdateStarts(SymbolModel* model)
        {
            ushort* starts = Distribution(model) + 1;
            ushort* count = Counts(model, model->m_capacity);
            uint scale = RescaleCounts(model), sum = 0;
            for (int i = 0; i < model->m_lastSymbol; i++)
            {
                sum += count[i];
                starts[i] = (ushort)((scale * sum) >> (31 - LengthBits));
            }
        }

        /// <summary>Halves counts that have grown too large, and says when the next update is.</summary>
        /// <returns>The factor that scales a sum of counts to 2^31.</returns>
        static uint RescaleCounts(SymbolModel* model)
        {
            int symbols = model->m_lastSymbol + 1;
            ushort* count = Counts(model, model->m_capacity);
            uint total = model->m_total + model->m_cycle;
            if (total > MaxTotal)
            {
                total = 0;
                for (int i = 0; i < symbols; i++)
                {
                    uint half = (count[i] + 1u) >> 1;
                    count[i] = (ushort)half;
                    total += half;
                }
            }
            model->m_total = total;
            int cycle = (5 * model->m_cycle) >> 2;
            int longest = (symbols + 6) << 3;
            if (cycle > longest)
                cycle = longest;
            model->m_cycle = (ushort)cycle;
            model->m_untilUpdate = (ushort)cycle;
            return 0x80000000u / total;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static ushort* Distribution(SymbolModel* model) => (ushort*)((byte*)model + HeaderBytes);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static ushort* Counts(SymbolModel* model, int capacity) => (ushort*)((byte*)model + HeaderBytes) + (capacity + 1);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static ushort* FirstSymbols(SymbolModel* model, int capacity) =>
            (ushort*)((byte*)model + HeaderBytes) + (2 * capacity + 1);
    }
}
