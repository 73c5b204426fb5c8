using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Core;
using FastPoints.Laz;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Octrees
{
    // Upper levels first; each node is handed on once, with the points that its file can hold: missing pages and files are holes
    // with warnings. It takes some 50 bytes for a node, up to 120 if its file exists, and 32 for an entry of the page being read.
    // Measured: 220 MB with the most nodes without files, all in one page.
    sealed class EptHierarchy
    {
        const string HierarchyFolder = "ept-hierarchy";

        // Room for 1.5 million nodes; writers begin new pages long before.
        const int MaxPageBytes = 32 << 20;

        // About a millisecond of parsing.
        const int SliceBytes = 128 << 10;

        // More nodes and pages than the largest clouds have: it bounds the memory of a hierarchy.
        const int MaxNodes = 1 << 21;

        // A compressed node is read whole.
        const long MaxCompressedBytes = 1L << 28;

        // Of one byte of a zstandard frame: a block of 128 KiB takes 4.
        const long MaxZstandardRatio = 1 << 15;

        // Looked up together: adding them takes far less than a millisecond of the main thread.
        const int StepNodes = 256;

        readonly EptIndex m_index;
        readonly EptReader m_reader;
        readonly UnreadPages m_waiting = new UnreadPages(EptEntry.MaxLevel + 1);
        readonly HashSet<int4> m_pages = new HashSet<int4>();
        readonly HashSet<int4> m_nodes = new HashSet<int4>();
        bool m_isFull;

        public EptHierarchy(EptReader reader)
        {
            m_index = reader.Index;
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
                string path = Path.Combine(m_index.Folder, HierarchyFolder, name + ".json");
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
            long length = FileSource.NoSuchFile;
            yield return JobStep.Of(PoolTask.Run(path, () => FileSource.LengthOf(path), found => length = found));
            string problem = null;
            if (length == FileSource.NoSuchFile)
                problem = "there is no " + Path.GetFileName(path);
            else if (length > MaxPageBytes)
                problem = "it has " + NumberText.Of(length) + " bytes, wanted at most " + NumberText.Of(MaxPageBytes);
            if (problem != null)
            {
                m_reader.Warnings.Add("the page of the hierarchy that begins with it cannot be read", name, problem);
                yield break;
            }
            m_index.Info.FileBytes += length;
            using var read = new NativeFileRead(length, Allocator.Persistent);
            using var state = new NativeReference<EptPageState>(Allocator.Persistent);
            JobHandle parsed = default;
            try
            {
                yield return read.Begin(Path.GetFullPath(path), 0, (int)length);
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
            // If it doubled as it grows, the set would exist twice for a while.
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
            var files = new string[step.Count];
            for (int i = 0; i < files.Length; i++)
                files[i] = step[i].Points > 0 ? m_reader.PathOf(step[i].Level, step[i].Cell) : null;
            return PoolTask.Run(path, () => Array.ConvertAll(files, FileSource.LengthOf), lengths =>
            {
                for (int i = 0; i < lengths.Length; i++)
                    Add(step[i], lengths[i], path);
            });
        }

        void Add(EptEntry entry, long length, string path)
        {
            if (m_nodes.Count + m_pages.Count > MaxNodes)
            {
                if (!m_isFull)
                    m_index.Info.Warn(-1, "the hierarchy has more than " + NumberText.Of(MaxNodes)
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
            if (bytes <= 0)
            {
                m_reader.Warnings.Add("its file is " + (bytes == 0 ? "empty" : "missing") + ": its points are left out",
                    entry.Name, NumberText.Of(entry.Points) + " points", -1, path);
                m_reader.Add(entry, 0, 0);
                return;
            }
            m_index.Info.FileBytes += bytes;
            long points = Math.Min(entry.Points, MaxPoints(bytes));
            if (points < entry.Points)
                m_reader.Warnings.Add("its file cannot hold the points that the hierarchy claims", entry.Name, "wanted "
                    + NumberText.Of(entry.Points) + ", got room for " + NumberText.Of(points) + " in " + NumberText.Of(bytes)
                    + " bytes", -1, path);
            else if (m_index.DataType == EptDataType.Binary && bytes > points * m_index.RecordBytes)
                m_reader.Warnings.Add("its file holds more than the points that the hierarchy claims", entry.Name,
                    "wanted " + NumberText.Of(points * m_index.RecordBytes) + " bytes, got " + NumberText.Of(bytes), -1, path);
            m_reader.Add(entry, points, bytes);
        }

        long MaxPoints(long bytes)
        {
            if (m_index.DataType == EptDataType.Binary)
                return bytes / m_index.RecordBytes;
            if (bytes > MaxCompressedBytes)
                return 0;
            return m_index.DataType == EptDataType.Laszip
                ? LazChunk.MaxPoints(bytes) : bytes * MaxZstandardRatio / m_index.RecordBytes;
        }
    }
}
