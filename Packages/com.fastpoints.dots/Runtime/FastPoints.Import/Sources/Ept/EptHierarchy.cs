using System;
using System.Collections.Generic;
using FastPoints.Laz;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Sources
{
    // Upper levels first; each node is added once, with the points that its file can hold: missing pages and files are holes
    // with warnings. It takes some 50 bytes for a node, up to 120 if its file exists, and 32 for an entry of the page being read.
    // Measured: 220 MB with the most nodes without files, all in one page.
    sealed class EptHierarchy
    {
        const string HierarchyFolder = "ept-hierarchy";
        const int MaxPageBytes = 32 << 20; // Room for 1.5 million nodes; writers begin new pages long before.
        const int SliceBytes = 128 << 10; // About a millisecond of parsing.
        const int MaxNodes = 1 << 21; // More nodes and pages than the largest clouds have: it bounds the memory of a hierarchy.
        const long MaxCompressedBytes = 1L << 28; // A compressed node is read whole.
        const long MaxZstandardRatio = 1 << 15; // Bytes from one byte of a zstandard frame: a block of 128 KiB takes 4.
        const long MaxRemotePoints = 1 << 22; // Of a remote node, whose file is not looked up.
        const int StepNodes = 256; // Looked up together: adding them takes far less than a millisecond of the main thread.

        readonly EptMetadata m_metadata;
        readonly EptReader m_reader;
        readonly UnreadPages m_waiting = new UnreadPages(EptEntry.MaxLevel + 1);
        readonly HashSet<int4> m_pages = new HashSet<int4>();
        readonly HashSet<int4> m_nodes = new HashSet<int4>();
        bool m_isFull;

        public EptHierarchy(EptReader reader)
        {
            m_metadata = reader.Metadata;
            m_reader = reader;
            m_waiting.Add(default);
            m_pages.Add(default);
        }

        // Coroutine: the pages that may contain nodes of the first levels, as far as they concern the node and what is below it.
        public IEnumerator<JobStep> Read(int4 node, int levels)
        {
            while (m_waiting.TryPeek(node, levels, out var page))
            {
                // If abandoned between two yields, this begins the page again; nodes that it had added are known by their keys.
                string name = EptEntry.NameOf(page.Root.w, page.Root.xyz);
                string path = SourcePath.Combine(SourcePath.Combine(m_metadata.Folder, HierarchyFolder), name + ".json");
                using (var entries = new NativeList<EptEntry>(64, Allocator.Persistent))
                {
                    yield return JobStep.Of(Parse(path, name, entries));
                    yield return JobStep.Of(Add(entries, path));
                }
                m_waiting.Remove(page);
                m_reader.Tree.PageCount++;
            }
        }

        public bool IsKnown(int4 node, int levels) => !m_waiting.TryPeek(node, levels, out _);

        // A missing page has no entries. name: the node that it begins with.
        IEnumerator<JobStep> Parse(string path, string name, NativeList<EptEntry> entries)
        {
            long length = RandomAccessFile.NoSuchFile;
            yield return JobStep.Of(PoolTask.Run(path, () => RandomAccessFile.LengthOf(path), found => length = found));
            string problem = null;
            if (length == RandomAccessFile.NoSuchFile)
                problem = "there is no " + SourcePath.NameOf(path);
            else if (length > MaxPageBytes)
                problem = "it has " + NumberText.Of(length) + " bytes, wanted at most " + NumberText.Of(MaxPageBytes);
            if (problem != null)
            {
                m_reader.Warnings.Add("the page of the hierarchy that begins with it cannot be read", name, problem);
                yield break;
            }
            m_metadata.Info.FileBytes += length;
            using var read = new NativeFileRead(length, Allocator.Persistent);
            using var state = new NativeReference<EptPageState>(Allocator.Persistent);
            JobHandle parsed = default;
            try
            {
                while (!read.TryFetch(path, 0, length))
                    yield return default;
                yield return read.Begin(SourcePath.Full(path), 0, (int)length);
                read.End();
                var parse = new ParseEptPageJob
                {
                    Text = read.Buffer,
                    TextBytes = (int)length,
                    SliceBytes = SliceBytes,
                    State = state,
                    Entries = entries,
                };
                do
                {
                    parsed = parse.Schedule();
                    yield return parsed;
                    parsed.Complete();
                }
                while (!state.Value.IsDone && !state.Value.IsBroken);
            }
            finally
            {
                parsed.Complete();
            }
            if (state.Value.IsBroken)
                m_reader.Warnings.Add("the page of the hierarchy that begins with it is broken",
                    name, "the first " + NumberText.Of(state.Value.Entries) + " entries are read", state.Value.At, path);
        }

        // Level by level: a parent comes before its children.
        IEnumerator<JobStep> Add(NativeList<EptEntry> entries, string path)
        {
            int first = int.MaxValue, last = -1;
            for (int i = 0; i < entries.Length; i++)
            {
                int level = entries[i].Level;
                if (!entries[i].HasKey)
                {
                    m_reader.Warnings.Add("an entry of the hierarchy is none", "?", null, entries[i].At, path);
                    continue;
                }
                first = Math.Min(first, level);
                last = Math.Max(last, level);
            }
            // Growing by doubling would hold the set twice for a while.
            m_nodes.EnsureCapacity(Math.Min(MaxNodes, m_nodes.Count + entries.Length));
            var step = new List<EptEntry>(StepNodes);
            for (int level = first; level <= last; level++)
                for (int i = 0; i < entries.Length; i++)
                {
                    if (entries[i].Level == level && entries[i].HasKey)
                        step.Add(entries[i]);
                    if (step.Count < StepNodes && (level < last || i < entries.Length - 1))
                        continue;
                    yield return JobStep.Of(Add(step, path));
                    step.Clear();
                }
        }

        IEnumerator<JobStep> Add(List<EptEntry> step, string path)
        {
            // To ask for each would take as many requests as to read all.
            if (SourcePath.IsRemote(path))
            {
                foreach (var entry in step)
                    Add(entry, NodeReader.UnknownBytes, path);
                return NoWork();
            }
            var files = new string[step.Count];
            for (int i = 0; i < files.Length; i++)
                files[i] = step[i].Points > 0 ? m_reader.PathOf(step[i].Level, step[i].Cell) : null;
            return PoolTask.Run(path, () => Array.ConvertAll(files, RandomAccessFile.LengthOf), lengths =>
            {
                for (int i = 0; i < lengths.Length; i++)
                    Add(step[i], lengths[i], path);
            });
        }

        static IEnumerator<JobStep> NoWork()
        {
            yield break;
        }

        void Add(EptEntry entry, long length, string path)
        {
            if (m_nodes.Count + m_pages.Count > MaxNodes)
            {
                if (!m_isFull)
                    m_metadata.Info.Warn(-1, "the hierarchy has more than " + NumberText.Of(MaxNodes)
                        + " nodes and pages: the others are left out");
                m_isFull = true;
                return;
            }
            if (entry.IsPage)
            {
                if (m_pages.Add(entry.Key))
                    m_waiting.Add(entry.Key);
                else
                    m_reader.Warnings.Add("its page of the hierarchy is named twice", entry.Name, null, entry.At, path);
                return;
            }
            if (!m_nodes.Add(entry.Key))
                m_reader.Warnings.Add("is in the hierarchy twice: the second is left out", entry.Name, null, entry.At, path);
            else if (entry.Points < 0)
                m_reader.Warnings.Add("has a number of points that is none", entry.Name, NumberText.Of(entry.Points), entry.At,
                    path);
            else
                AddNode(entry, length);
        }

        void AddNode(EptEntry entry, long bytes)
        {
            if (entry.Points == 0)
            {
                m_reader.Add(entry, 0, 0);
                return;
            }
            string path = m_reader.PathOf(entry.Level, entry.Cell);
            if (bytes == NodeReader.UnknownBytes)
            {
                AddRemote(entry, path);
                return;
            }
            if (bytes <= 0)
            {
                m_reader.Warnings.Add("its file is " + (bytes == 0 ? "empty" : "missing") + ": its points are left out",
                    entry.Name, NumberText.Of(entry.Points) + " points", -1, path);
                m_reader.Add(entry, 0, 0);
                return;
            }
            m_metadata.Info.FileBytes += bytes;
            long points = Math.Min(entry.Points, MaxPoints(bytes));
            if (points < entry.Points)
                m_reader.Warnings.Add("its file cannot hold the points that the hierarchy claims", entry.Name, "wanted "
                    + NumberText.Of(entry.Points) + ", got room for " + NumberText.Of(points) + " in " + NumberText.Of(bytes)
                    + " bytes", -1, path);
            else if (m_metadata.DataType == EptDataType.Binary && bytes > points * m_metadata.RecordBytes)
                m_reader.Warnings.Add("its file holds more than the points that the hierarchy claims", entry.Name,
                    "wanted " + NumberText.Of(points * m_metadata.RecordBytes) + " bytes, got " + NumberText.Of(bytes), -1, path);
            m_reader.Add(entry, points, bytes);
        }

        // Its file may turn out to be shorter, or missing, when it is read.
        void AddRemote(EptEntry entry, string path)
        {
            long points = Math.Min(entry.Points, MaxRemotePoints);
            if (points < entry.Points)
                m_reader.Warnings.Add("has too many points for a remote file", entry.Name, "wanted at most "
                    + NumberText.Of(MaxRemotePoints) + ", got " + NumberText.Of(entry.Points), -1, path);
            m_reader.Add(entry, points, NodeReader.UnknownBytes);
        }

        long MaxPoints(long bytes)
        {
            if (m_metadata.DataType == EptDataType.Binary)
                return bytes / m_metadata.RecordBytes;
            if (bytes > MaxCompressedBytes)
                return 0;
            return m_metadata.DataType == EptDataType.Laszip
                ? LazChunk.MaxPoints(bytes) : bytes * MaxZstandardRatio / m_metadata.RecordBytes;
        }
    }

    // A flat JSON object of "level-x-y-z": points. A job without the JSON parser, since pages of large clouds are megabytes: it
    // makes no garbage.
    [BurstCompile]
    internal struct ParseEptPageJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Text;
        public int TextBytes;
        public int SliceBytes; // The slice ends after this many bytes, between two entries.

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
        public int Entries; // Including those without a valid key.

        public bool IsDone;
        public bool IsBroken; // The text stops being such a page at At; earlier entries are valid.
    }

    internal struct EptEntry
    {
        public const long PointCountOfPage = -1;
        public const int MaxLevel = 30; // The cells of deeper nodes do not fit into an int.

        // -1 if the key is invalid.
        public int Level;
        public int3 Cell;
        public long Points;
        public int At;

        public bool IsPage => Points == PointCountOfPage;
        public bool HasKey => Level >= 0 && Level <= MaxLevel && math.all(Cell >= 0) && math.all(Cell < 1 << Level);
        public int4 Key => new int4(Cell.x, Cell.y, Cell.z, Level);
        public string Name => NameOf(Level, Cell);

        public static string NameOf(int level, int3 cell) =>
            NumberText.Of(level) + "-" + NumberText.Of(cell.x) + "-" + NumberText.Of(cell.y) + "-" + NumberText.Of(cell.z);
    }
}
