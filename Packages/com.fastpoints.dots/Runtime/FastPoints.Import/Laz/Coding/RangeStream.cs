using System.Runtime.CompilerServices;

namespace FastPoints.Laz
{
    /// <summary>A range-coded stream between two slices of its decoding. Within a slice the pointers are valid; only
    /// <see cref="Offset"/> is kept, since the input may lie elsewhere the next time.</summary>
    internal unsafe struct RangeStream
    {
        public uint Value;
        public uint Length;
        public byte* Next;
        public byte* End; // A decoder that has passed it has read foreign bytes.

        public long Offset;

        public bool IsBeyondEnd => Next > End;

        public bool IsAtEnd => Next >= End;

        /// <summary>Whether an encoder can have ended here: it adds a part of its interval to the base, writes the one or two
        /// bytes that the part leaves above zero, and three or two zeros, so that a decoder ends with the stream. Of a stream
        /// that goes on at most the points that take no byte, less than eight bits together, leave it so.</summary>
        /// <param name="input">No byte before it is looked at.</param>
        public bool CanEnd(byte* input)
        {
            if (Next != End)
                return false;
            const uint Min = RangeCoder.MinLength;
            bool isLong = Length > 2 * Min;
            for (int i = 1; i <= (isLong ? 3 : 2) && Next - i >= input; i++)
                if (Next[-i] != 0)
                    return false;
            return isLong ? Value > 0 && Value <= Min : Value <= Min >> 1 && Value > (Min >> 1) - (1 << 16);
        }

        public void Start(byte* first, byte* end)
        {
            Next = first;
            End = end;
            RangeCoder.StartDecoding(out Value, out Length, ref Next);
        }

        public void StartWriting(byte* first) => Save(0, uint.MaxValue, first);

        // Of a coder's locals, which stay in registers because nothing refers to them.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Save(uint value, uint length, byte* next)
        {
            Value = value;
            Length = length;
            Next = next;
        }

        public void Resume(byte* input, byte* end)
        {
            Next = input + Offset;
            End = end;
        }

        public void Suspend(byte* input) => Offset = Next - input;
    }
}
