using System;
using System.Collections.Generic;
using FastPoints.Store;
using Unity.Collections;

namespace FastPoints.Reading
{
    // Several files as one cloud: their blocks one after the other, all attributes of all, positions on one grid that holds
    // every file's numbers exactly. Each header is read once; a file is opened again when its blocks are read, and at most
    // MaxOpen stay open (or one for each slot if there are more), so many files do not take many handles.
    internal sealed class TiledReader : PointReader
    {
        public const int MaxOpen = 32;

        const int MaxListed = 20;

        const int MaxEqualWarnings = 3;
        const int MaxWarnings = 1000;

        readonly List<Tile> m_tiles = new List<Tile>();
        readonly List<Tile> m_open = new List<Tile>();
        readonly Dictionary<PointSchema, PointSchema> m_schemas = new Dictionary<PointSchema, PointSchema>();
        readonly Dictionary<string, int> m_warningCounts = new Dictionary<string, int>();
        readonly bool m_skipsUnreadable;
        readonly Func<string, PointReader> m_openFile;
        bool m_blocksAreKnown;
        int m_blockCount;
        int m_maxPointsPerBlock;
        bool m_hasCheapRanges = true;
        bool m_isRemote;
        bool m_hasMoreWarnings;
        long m_clock;

        TiledReader(string name, bool skipsUnreadable, Func<string, PointReader> openFile)
        {
            m_skipsUnreadable = skipsUnreadable;
            m_openFile = openFile;
            Info = new SourceInfo { Path = name };
        }

        // info: of more files, of which these are some: they get its attributes and its transform.
        public static TiledReader Open(IReadOnlyList<string> paths, Func<string, PointReader> openFile, SourceInfo info = null)
        {
            if (paths.Count == 0)
                throw new PointCloudException(FailureCode.NotFound, "(no path)", -1, "no file was named");
            string first = SourcePath.WithoutQuery(paths[0]);
            string name = paths.Count == 1 ? first : first + " and " + (paths.Count - 1) + " more";
            return new TiledReader(name, false, openFile).OpenAll(paths, info);
        }

        // All point clouds of a folder in the order of their names (by character code), not those in folders within. Files that
        // cannot be read are left out with a warning.
        public static TiledReader OpenFolder(string folder, bool isRecursive, Func<string, PointReader> openFile)
        {
            var paths = new List<string>();
            var folders = new List<string>();
            SourceFolder.List(folder, isRecursive, paths, folders);
            var reader = new TiledReader(folder, true, openFile);
            if (folders.Count > 0)
                reader.Info.Warn(-1, "folders in it are not looked into: " + string.Join(", ", folders.GetRange(0,
                    Math.Min(folders.Count, MaxListed))) + (folders.Count > MaxListed
                        ? " and " + (folders.Count - MaxListed) + " more" : ""));
            return reader.OpenAll(paths);
        }

        public int TileCount => m_tiles.Count;

        internal override bool IsRemote => m_isRemote;

        internal override void ListPieces(BlockRange range, List<FilePiece> pieces)
        {
            var tile = TileOfBlock(range.Block);
            if (tile.Reader != null && tile.Reader.IsRemote)
                tile.Reader.ListPieces(new BlockRange(range.Block - tile.FirstBlock, range.First, range.Count), pieces);
        }

        public override bool BlocksAreKnown => m_blocksAreKnown;
        public override int BlockCount => m_blocksAreKnown ? m_blockCount
            : throw new InvalidOperationException("IndexBlocks comes first");
        public override int MaxPointsPerBlock => m_maxPointsPerBlock;
        public override bool HasCheapRanges => m_hasCheapRanges;

        public int OpenCount
        {
            get
            {
                int count = 0;
                foreach (var tile in m_open)
                    count += tile.IsOpen ? 1 : 0;
                return count;
            }
        }

        public override long FirstPointOfBlock(int block)
        {
            var tile = TileOfBlock(block);
            return tile.FirstPoint + tile.StartOf(block - tile.FirstBlock);
        }

        public override int PointsInBlock(int block)
        {
            var tile = TileOfBlock(block);
            return (int)(tile.StartOf(block - tile.FirstBlock + 1) - tile.StartOf(block - tile.FirstBlock));
        }

        public List<string> Paths => m_tiles.ConvertAll(tile => tile.Path);

        /// <summary>Empty where the header says nothing that can be true.</summary>
        public BoundsGeo BoundsOf(int tile) => m_tiles[tile].Bounds;

        public (int First, int Count) BlocksOf(int tile) => (m_tiles[tile].FirstBlock, m_tiles[tile].BlockCount);

        public SourceEntry TileEntryOf(int tile) => new SourceEntry
        {
            Name = m_tiles[tile].Path,
            FileBytes = m_tiles[tile].FileBytes,
            HeadHash = m_tiles[tile].HeadHash,
            Points = m_tiles[tile].Points,
            Crs = m_tiles[tile].Crs,
        };

        public override long BytesOfRange(BlockRange range)
        {
            var tile = TileOfBlock(range.Block);
            if (tile.Reader != null)
                return tile.Reader.BytesOfRange(new BlockRange(range.Block - tile.FirstBlock, range.First, range.Count));
            return tile.HasCheapRanges && tile.RecordBytes > 0
                ? (long)range.Count * tile.RecordBytes
                : (long)(tile.FileBytes / (double)Math.Max(1, tile.Points) * range.Count);
        }

        public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator)
        {
            _ = BlockCount;
            return new TiledRead(this, wanted, capacity, allocator);
        }

        public override IEnumerator<JobStep> IndexBlocks()
        {
            if (BlocksAreKnown)
                yield break;
            foreach (var tile in m_tiles)
            {
                if (tile.IsKnown)
                    continue;
                Acquire(tile);
                try
                {
                    tile.Reader.MaxIndexingJobs = MaxIndexingJobs;
                    using (var work = new CoroutineStack(tile.Reader.IndexBlocks()))
                        while (Step(work, tile))
                            yield return work.Current;
                    if (tile.Reader.BlocksAreKnown)
                        AddBlocks(tile);
                    TakeWarnings(tile);
                }
                finally
                {
                    Release(tile);
                }
            }
            Finish();
        }

        // In a folder, a tile that turns out to be broken is left out.
        bool Step(CoroutineStack work, Tile tile)
        {
            try
            {
                return work.MoveNext();
            }
            catch (PointCloudException e) when (m_skipsUnreadable && e.IsInputAtFault)
            {
                WarnLeftOut(tile.Path, e);
                return false;
            }
        }

        internal Tile TileOfBlock(int block)
        {
            if ((uint)block >= (uint)BlockCount)
                throw new ArgumentOutOfRangeException(nameof(block), block, "the source has " + BlockCount + " blocks");
            int low = 0, high = m_tiles.Count - 1;
            while (low < high)
            {
                int middle = (low + high + 1) / 2;
                if (m_tiles[middle].FirstBlock <= block)
                    low = middle;
                else
                    high = middle - 1;
            }
            return m_tiles[low];
        }

        internal void Acquire(Tile tile)
        {
            tile.LastUse = ++m_clock;
            if (tile.IsOpen)
            {
                tile.Users++;
                return;
            }
            CloseOldest();
            if (tile.Reader == null)
            {
                var reader = m_openFile(tile.Path);
                if (reader.Info.FileBytes != tile.FileBytes || reader.BlocksAreKnown != tile.IsKnown ||
                    tile.IsKnown && (reader.BlockCount != tile.BlockCount || reader.PointCount != tile.Points))
                {
                    reader.Dispose();
                    throw PointCloudException.Wanted(FailureCode.ReadFailed, tile.Path, -1, "the file has changed",
                        tile.FileBytes + " bytes as before", reader.Info.FileBytes);
                }
                tile.Reader = reader;
            }
            tile.IsOpen = true;
            tile.Users++;
            if (!m_open.Contains(tile))
                m_open.Add(tile);
        }

        internal void Release(Tile tile) => tile.Users--;

        internal void TakeWarnings(Tile tile)
        {
            var warnings = tile.Reader.Info.Warnings;
            if (warnings.Count == 0)
                return;
            tile.Warnings ??= new List<int>();
            for (int i = 0; i < warnings.Count; i++)
            {
                var warning = warnings[i];
                bool isReported = false;
                foreach (int index in tile.Warnings)
                    isReported |= index >= 0 && Info.Warnings[index].ByteOffset == warning.ByteOffset &&
                        Info.Warnings[index].Path == warning.Path && Info.Warnings[index].Text == warning.Text;
                if (isReported)
                    continue;
                // A reader continues counting in the warning that it has.
                if (i < tile.Warnings.Count && tile.Warnings[i] >= 0 && !Contains(warnings, Info.Warnings[tile.Warnings[i]]))
                    Info.Warnings[tile.Warnings[i]] = warning;
                else if (i >= tile.Warnings.Count)
                    tile.Warnings.Add(Report(warning));
            }
        }

        static bool Contains(List<CloudWarning> warnings, CloudWarning wanted)
        {
            foreach (var warning in warnings)
                if (warning.ByteOffset == wanted.ByteOffset && warning.Text == wanted.Text)
                    return true;
            return false;
        }

        // Its index, or -1 after MaxEqualWarnings of the same text, or MaxWarnings in all.
        int Report(CloudWarning warning)
        {
            if (m_warningCounts.Count == MaxWarnings && !m_warningCounts.ContainsKey(warning.Text))
            {
                if (!m_hasMoreWarnings)
                    Info.Warn(-1, "more files have other warnings");
                m_hasMoreWarnings = true;
                return -1;
            }
            m_warningCounts.TryGetValue(warning.Text, out int reported);
            m_warningCounts[warning.Text] = reported + 1;
            if (reported > MaxEqualWarnings)
                return -1;
            if (reported == MaxEqualWarnings)
                warning = new CloudWarning(Info.Path, -1, "more files say: " + warning.Text);
            Info.Warnings.Add(warning);
            return reported == MaxEqualWarnings ? -1 : Info.Warnings.Count - 1;
        }

        public override void CloseFile()
        {
            foreach (var tile in m_open)
                Close(tile);
            m_open.Clear();
        }

        public override void DisposeUnread()
        {
            foreach (var tile in m_tiles)
            {
                tile.Reader?.DisposeUnread();
                tile.Reader = null;
            }
        }

        void CloseOldest()
        {
            while (m_open.Count >= MaxOpen)
            {
                Tile oldest = null;
                foreach (var tile in m_open)
                    if (tile.Users == 0 && (oldest == null || tile.LastUse < oldest.LastUse))
                        oldest = tile;
                if (oldest == null)
                    return;
                m_open.Remove(oldest);
                Close(oldest);
            }
        }

        static void Close(Tile tile)
        {
            tile.IsOpen = false;
            // Finding this again would take another pass over the file, or requests.
            if (!tile.IsKnown || tile.Reader.IsRemote)
            {
                tile.Reader.CloseFile();
                return;
            }
            tile.Reader.Dispose();
            tile.Reader = null;
        }

        TiledReader OpenAll(IReadOnlyList<string> paths, SourceInfo info = null)
        {
            var summary = new TileSummary(Info);
            var otherFiles = new List<string>();
            bool isKnown = true;
            foreach (string path in paths)
            {
                PointReader reader;
                try
                {
                    reader = m_openFile(path);
                }
                catch (PointCloudException e) when (m_skipsUnreadable)
                {
                    if (e.Code == FailureCode.Unsupported && e.ByteOffset == 0)
                        otherFiles.Add(SourcePath.NameOf(path));
                    else
                        WarnLeftOut(path, e);
                    continue;
                }
                try
                {
                    var tile = new Tile
                    {
                        Path = path,
                        FileBytes = reader.Info.FileBytes,
                        HeadHash = reader.Info.HeadHash,
                        Bounds = reader.Info.BoundsIfFinite,
                        Schema = Shared(reader.Info.Schema),
                        Transform = reader.Info.Transform,
                        IsKnown = reader.BlocksAreKnown,
                        HasCheapRanges = reader.HasCheapRanges,
                        RecordBytes = reader.Info.RecordBytes,
                        Crs = summary.SharedCrs(reader.Info),
                        Reader = reader,
                    };
                    m_tiles.Add(tile);
                    if (tile.IsKnown)
                        AddBlocks(tile);
                    isKnown &= tile.IsKnown;
                    m_hasCheapRanges &= tile.HasCheapRanges;
                    summary.Include(reader.Info);
                    if (m_tiles.Count <= MaxListed)
                        Info.AddFact(SourcePath.NameOf(path), summary.Describe(reader.Info));
                    TakeWarnings(tile);
                    m_isRemote |= reader.IsRemote;
                    if (!reader.IsRemote)
                        tile.Reader = null;
                }
                finally
                {
                    if (!reader.IsRemote)
                        reader.DisposeUnread();
                }
            }
            if (otherFiles.Count > 0)
                Info.Warn(-1, (otherFiles.Count == 1 ? "1 file in it is" : otherFiles.Count + " files in it are") +
                    " no point cloud: " + otherFiles[0] +
                    (otherFiles.Count > 1 ? " and others" : ""));
            if (m_tiles.Count == 0)
                throw new PointCloudException(FailureCode.Unsupported, Info.Path, -1, "the folder has no point cloud that can " +
                    "be read" + (Info.Warnings.Count > 0 ? ": " + Info.Warnings[Info.Warnings.Count - 1].Text : ""));
            if (m_tiles.Count > MaxListed)
                Info.AddFact("and", (m_tiles.Count - MaxListed) + " more files");
            summary.End(m_tiles.Count);
            if (info == null)
                new TileSchema(m_tiles, Info).MergeSchemas();
            else
                (Info.Schema, Info.Transform) = (info.Schema, info.Transform);
            if (isKnown)
                Finish();
            return this;
        }

        void WarnLeftOut(string path, PointCloudException failure)
        {
            string text = failure.Message.StartsWith(failure.Path + ": ", StringComparison.Ordinal)
                ? failure.Message.Substring(failure.Path.Length + 2)
                : failure.Message;
            Report(new CloudWarning(path, -1, "left out: " + text));
        }

        PointSchema Shared(PointSchema schema)
        {
            if (!m_schemas.TryGetValue(schema, out var shared))
                m_schemas[schema] = shared = schema;
            return shared;
        }

        static void AddBlocks(Tile tile)
        {
            var reader = tile.Reader;
            tile.BlockCount = reader.BlockCount;
            tile.Points = reader.PointCount;
            tile.MaxPointsPerBlock = tile.BlockCount == 0 ? 0 : reader.MaxPointsPerBlock;
            bool isEven = true;
            for (int block = 1; block < tile.BlockCount; block++)
                isEven &= reader.FirstPointOfBlock(block) == (long)block * tile.MaxPointsPerBlock;
            if (isEven)
                return;
            tile.Starts = new long[tile.BlockCount];
            for (int block = 0; block < tile.BlockCount; block++)
                tile.Starts[block] = reader.FirstPointOfBlock(block);
        }

        // Tiles without points get the first block of the next tile, and come before it.
        void Finish()
        {
            long points = 0;
            foreach (var tile in m_tiles)
            {
                (tile.FirstBlock, tile.FirstPoint) = (m_blockCount, points);
                m_blockCount = checked(m_blockCount + tile.BlockCount);
                points += tile.Points;
                m_maxPointsPerBlock = Math.Max(m_maxPointsPerBlock, tile.MaxPointsPerBlock);
            }
            m_blocksAreKnown = true;
            Info.PointsReadable = points;
        }
    }
}
