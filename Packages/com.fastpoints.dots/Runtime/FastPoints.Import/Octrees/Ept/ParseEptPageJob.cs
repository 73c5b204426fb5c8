using FastPoints.Core;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Octrees
{
    // A flat JSON object of "level-x-y-z": points. A job without the JSON parser, since pages of large clouds are megabytes: it
    // makes no garbage.
    [BurstCompile]
    internal struct ParseEptPageJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Text;
        public int TextBytes;

        // The slice ends after this many bytes, between two entries.
        public int SliceBytes;

        public NativeReference<EptPageState> State;
        public NativeList<EptEntry> Entries;

        public void Execute()
        {
            var state = State.Value;
            int end = state.At + SliceBytes;
            if (state.At == 0 && !state.IsBroken)
                Open(ref state);
            while (!state.IsDone && !state.IsBroken && state.At < end)
                ReadEntry(ref state);
            State.Value = state;
        }

        void Open(ref EptPageState state)
        {
            if (TextBytes >= 3 && Text[0] == 0xEF && Text[1] == 0xBB && Text[2] == 0xBF)
                state.At = 3;
            Expect(ref state, (byte)'{');
        }

        void ReadEntry(ref EptPageState state)
        {
            SkipBlanks(ref state.At);
            // A comma behind the last entry is accepted, as elsewhere.
            if (Peek(state.At) == '}')
            {
                state.IsDone = true;
                return;
            }
            var entry = new EptEntry { At = state.At };
            if (!Expect(ref state, (byte)'"'))
                return;
            ReadKey(ref state, ref entry);
            if (state.IsBroken || !Expect(ref state, (byte)':') || !ReadNumber(ref state, out entry.Points))
                return;
            Entries.Add(entry);
            state.Entries++;
            SkipBlanks(ref state.At);
            if (Peek(state.At) != '}')
                Expect(ref state, (byte)',');
        }

        void ReadKey(ref EptPageState state, ref EptEntry entry)
        {
            int at = state.At;
            bool isKey = ReadIndex(ref at, '-', out entry.Level) & ReadIndex(ref at, '-', out int x)
                & ReadIndex(ref at, '-', out int y) & ReadIndex(ref at, '"', out int z);
            entry.Cell = new int3(x, y, z);
            if (isKey)
            {
                state.At = at;
                return;
            }
            // This is some other member: skip to the end of its name.
            entry.Level = -1;
            while (state.At < TextBytes && Text[state.At] != '"')
                state.At += Text[state.At] == '\\' ? 2 : 1;
            if (state.At >= TextBytes)
                state.IsBroken = true;
            else
                state.At++;
        }

        // Digits up to an end mark, of a number that fits into an int.
        bool ReadIndex(ref int at, int end, out int value)
        {
            long number = 0;
            int first = at;
            while (at < TextBytes && Text[at] >= '0' && Text[at] <= '9' && number <= int.MaxValue)
                number = number * 10 + (Text[at++] - '0');
            value = (int)math.min(number, int.MaxValue);
            bool isIndex = at > first && number <= int.MaxValue && Peek(at) == end;
            at++;
            return isIndex;
        }

        bool ReadNumber(ref EptPageState state, out long value)
        {
            value = 0;
            SkipBlanks(ref state.At);
            bool isNegative = Peek(state.At) == '-';
            if (isNegative)
                state.At++;
            int first = state.At;
            while (state.At < TextBytes && Text[state.At] >= '0' && Text[state.At] <= '9')
            {
                if (value < long.MaxValue / 10 - 1)
                    value = value * 10 + (Text[state.At] - '0');
                state.At++;
            }
            int next = Peek(state.At);
            if (state.At == first || next == '.' || next == 'e' || next == 'E')
                state.IsBroken = true;
            if (isNegative)
                value = -value;
            return !state.IsBroken;
        }

        bool Expect(ref EptPageState state, byte wanted)
        {
            SkipBlanks(ref state.At);
            if (Peek(state.At) != wanted)
                state.IsBroken = true;
            else
                state.At++;
            return !state.IsBroken;
        }

        void SkipBlanks(ref int at)
        {
            while (at < TextBytes && (Text[at] == ' ' || Text[at] >= 9 && Text[at] <= 13))
                at++;
        }

        // -1 at the end.
        int Peek(int at) => at < TextBytes ? Text[at] : -1;
    }

    internal struct EptPageState
    {
        public int At;

        // Including those without a valid key.
        public int Entries;

        public bool IsDone;

        // The text stops being such a page at At; earlier entries are valid.
        public bool IsBroken;
    }

    internal struct EptEntry
    {
        public const long PageCount = -1;

        // The cells of deeper nodes do not fit into an int.
        public const int MaxLevel = 30;

        // -1 if the key is invalid.
        public int Level;
        public int3 Cell;
        public long Points;
        public int At;

        public bool IsPage => Points == PageCount;
        public bool HasKey => Level >= 0 && Level <= MaxLevel && math.all(Cell >= 0) && math.all(Cell < 1 << Level);
        public int4 Key => new int4(Cell.x, Cell.y, Cell.z, Level);
        public string Name => NameOf(Level, Cell);

        public static string NameOf(int level, int3 cell) =>
            NumberText.Of(level) + "-" + NumberText.Of(cell.x) + "-" + NumberText.Of(cell.y) + "-" + NumberText.Of(cell.z);
    }
}
