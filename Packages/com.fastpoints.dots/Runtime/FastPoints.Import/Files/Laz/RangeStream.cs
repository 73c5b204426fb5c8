namespace FastPoints.Files
{
    /// <summary>
    /// A range-coded stream between two slices of its decoding. Within a slice the pointers are valid; what is kept is
    /// <see cref="Offset"/>, since the input may lie elsewhere the next time.
    /// </summary>
    public unsafe struct RangeStream
    {
        public uint Value;
        public uint Length;
        public byte* Next;

        /// <summary>Behind the stream's last byte: a decoder that has gone further has read what is not its own.</summary>
        public byte* End;

        /// <summary>Of <see cref="Next"/> from the input's start.</summary>
        public long Offset;

        public bool IsBeyondEnd => Next > End;

        /// <summary>Starts at a stream's first byte.</summary>
        public void Start(byte* first, byte* end)
        {
            Next = first;
            End = end;
            RangeCode.Start(out Value, out Length, ref Next);
        }

        /// <summary>Takes up where <see cref="Suspend"/> left off, the input now being at <paramref name="input"/>.</summary>
        public void Resume(byte* input, byte* end)
        {
            Next = input + Offset;
            End = end;
        }

        public void Suspend(byte* input) => Offset = Next - input;
    }
}
