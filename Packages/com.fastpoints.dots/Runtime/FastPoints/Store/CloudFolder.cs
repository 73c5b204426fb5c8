using System;
using System.Collections.Generic;
using System.IO;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Store
{
    /// <summary>An opened cloud: its manifest, its upper nodes and a record for each chunk, whose tables are loaded on request.
    /// Everything is checked before it is used.</summary>
    public sealed unsafe class CloudFolder : IDisposable
    {
        const int MaxTableFetches = 32;

        CloudFolder(string path, CloudManifest manifest)
        {
            FolderPath = path;
            Manifest = manifest;
            Layout = manifest.CreateLayout();
        }

        readonly Dictionary<int, RemoteRead> m_fetched = new Dictionary<int, RemoteRead>(); // By chunk: tables.
        RemoteFile[] m_remote; // By page; null on this machine's disk.

        public string FolderPath { get; }
        public CloudManifest Manifest { get; }

        /// <summary>It is being built, or does not have its final name yet: paths in it will change.</summary>
        public bool IsUnfinished => Manifest.IsBuilding || FolderPath.EndsWith(StoreFormat.PartSuffix, StringComparison.Ordinal);
        public StoreLayout Layout { get; }

        /// <summary>The nodes of the upper levels; their planes are in upper.bin.</summary>
        public NodeTable Upper { get; private set; }

        // Null unless the folder was opened to be shown.
        internal CheckedPlanes Checked { get; private set; }

        /// <summary>Chunk records, in the order of the upper nodes that they are attached to.</summary>
        public NativeArray<ChunkRecord> Chunks { get; private set; }

        public string UpperPath => SourcePath.Combine(FolderPath, Manifest.UpperName);

        public string ChunkPath(int chunk) => SourcePath.Combine(FolderPath, StoreFormat.ChunkPath(Chunks[chunk].Number));

        // upper.bin (0) or a chunk's file (from 1 on) on a web server; null on this machine's disk. The hierarchy has the hashes
        // of all that is read of it, so that no request goes before the first range.
        internal RemoteFile RemoteOf(int page)
        {
            if (m_remote == null)
                return null;
            return m_remote[page] ??= page == 0
                ? RemoteFile.Of(UpperPath, Manifest.UpperBytes, VersionOf(Manifest.HierarchyHash))
                : RemoteFile.Of(ChunkPath(page - 1), Chunks[page - 1].FileBytes, VersionOf(Chunks[page - 1].TableHash));
        }

        string VersionOf(ulong hash) => Manifest.CloudId.ToString("x16") + hash.ToString("x16");

        /// <summary>Whether a path looks like a cloud's folder. Of an address the name alone says so.</summary>
        public static bool IsCloud(string path) => SourcePath.IsRemote(path)
            ? SourcePath.NameOf(path).EndsWith(StoreFormat.FolderExtension, StringComparison.OrdinalIgnoreCase)
            : File.Exists(Path.Combine(Find(path), StoreFormat.ManifestName));

        /// <summary>Finds a cloud under its name, or, if that does not exist yet, its unfinished folder.</summary>
        public static string Find(string path)
        {
            string name = path.TrimEnd(Path.DirectorySeparatorChar, Path.AltDirectorySeparatorChar);
            return SourcePath.IsRemote(path) || Directory.Exists(path) ||
                !Directory.Exists(name + StoreFormat.PartSuffix) ? path : name + StoreFormat.PartSuffix;
        }

        /// <exception cref="PointCloudException">It is not a cloud, or its manifest or hierarchy is damaged.</exception>
        public static CloudFolder Open(string path)
        {
            path = Find(path);
            // An unfinished cloud may get another generation while its files are opened.
            for (int attempt = 0; ; attempt++)
            {
                try
                {
                    return OpenOnce(path);
                }
                catch (PointCloudException) when (attempt < 3 && path.EndsWith(StoreFormat.PartSuffix, StringComparison.Ordinal))
                {
                    path = Find(path.Substring(0, path.Length - StoreFormat.PartSuffix.Length));
                }
            }
        }

        // The next Open asks a web server what it has by then.
        internal static void Doubt(string path)
        {
            foreach (string name in new[] { StoreFormat.ManifestName, StoreFormat.HierarchyName })
                if (SourcePath.IsRemote(path))
                    RemoteFile.Find(SourcePath.Combine(path, name))?.Doubt();
        }

        static CloudFolder OpenOnce(string path)
        {
            string manifestPath = SourcePath.Combine(path, StoreFormat.ManifestName);
            var folder = Open(path, CloudManifest.FromJson(StoreFile.ReadText(manifestPath), manifestPath));
            // What comes from elsewhere is hashed each time.
            if (SourcePath.IsRemote(path))
            {
                folder.m_remote = new RemoteFile[1 + folder.Chunks.Length];
                return folder;
            }
            var files = new List<(string, int)> { (folder.UpperPath, folder.Upper.Nodes.Length) };
            for (int chunk = 0; chunk < folder.Chunks.Length; chunk++)
                files.Add((folder.ChunkPath(chunk), folder.Chunks[chunk].NodeCount));
            folder.Checked = CheckedPlanes.Of(folder.Manifest.CloudId, folder.Layout.Planes.Count, files,
                folder.IsUnfinished ? null : folder.FolderPath);
            return folder;
        }

        /// <summary>Opens a folder that is complete except for cloud.json. Throws if its hierarchy is another one.</summary>
        public static CloudFolder Open(string path, CloudManifest manifest)
        {
            var folder = new CloudFolder(path, manifest);
            try
            {
                folder.ReadHierarchy();
                return folder;
            }
            catch
            {
                folder.Dispose();
                throw;
            }
        }

        public void Dispose()
        {
            Upper?.Dispose();
            foreach (var fetched in m_fetched.Values)
                fetched.Dispose();
            m_fetched.Clear();
            if (Chunks.IsCreated)
                Chunks.Dispose();
            Chunks = default;
        }

        /// <summary>The nodes of one chunk; the caller disposes the table.</summary>
        public NodeTable LoadTable(int chunk)
        {
            if (m_remote == null)
                return LoadTable(ChunkPath(chunk), Chunks[chunk]);
            IsTableFetched(chunk);
            using var fetched = m_fetched[chunk];
            m_fetched.Remove(chunk);
            fetched.Await();
            using var bytes = new NativeArray<byte>((int)fetched.Bytes, Allocator.Persistent);
            UnsafeUtility.MemCpy(bytes.GetUnsafePtr(), fetched.Data, bytes.Length);
            return TableOf(ChunkPath(chunk), Chunks[chunk], bytes);
        }

        // For callers that load all tables in this order.
        internal void FetchTablesFrom(int chunk)
        {
            for (int c = chunk; m_remote != null && c < Math.Min(chunk + MaxTableFetches, Chunks.Length); c++)
                IsTableFetched(c);
        }

        // Whether LoadTable does not wait for a web server. Begins to fetch the table if not.
        internal bool IsTableFetched(int chunk)
        {
            if (m_remote == null)
                return true;
            if (!m_fetched.TryGetValue(chunk, out var fetched))
                m_fetched.Add(chunk, fetched =
                    RemoteOf(1 + chunk).Begin(Chunks[chunk].TableOffset, TableBytes(Chunks[chunk]), chunk));
            return fetched.IsDone;
        }

        // On any thread, even while the folder is disposed.
        internal NodeTable LoadTable(string path, in ChunkRecord record, RemoteFile remote = null)
        {
            if (remote == null)
                CheckHeader(path, record);
            using var bytes = remote != null
                ? StoreFile.Read(remote, record.TableOffset, TableBytes(record), Allocator.Persistent)
                : StoreFile.Read(path, record.TableOffset, TableBytes(record), Allocator.Persistent);
            return TableOf(path, record, bytes);
        }

        void CheckHeader(string path, in ChunkRecord record)
        {
            var header = StoreFile.ReadHeader(path, StoreFormat.ChunkMagic);
            if (header.CloudId != Manifest.CloudId || header.Number != record.Number || header.NodeCount != record.NodeCount ||
                header.PointCount != record.PointCount || header.FileBytes != record.FileBytes ||
                    header.PlaneCount != Layout.Planes.Count ||
                header.TableOffset != record.TableOffset || header.TableHash != record.TableHash || header.ChunkCount != 0)
                throw new PointCloudException(FailureCode.BadInput, path, 0, "is not the file that the hierarchy means");
        }

        long TableBytes(in ChunkRecord record) =>
            record.NodeCount * (NodeRecord.SizeBytes + (long)Layout.Planes.Count * PlaneRange.SizeBytes);

        NodeTable TableOf(string path, in ChunkRecord record, NativeArray<byte> bytes)
        {
            ulong hash = ContentHash.Of(bytes.GetUnsafeReadOnlyPtr(), bytes.Length);
            if (hash != record.TableHash)
                throw new PointCloudException(FailureCode.BadInput, path, record.TableOffset,
                    "the node table is damaged: " + StoreFile.HashProblem(record.TableHash, hash));
            var table = Take(bytes, record.NodeCount, Layout.Planes.Count);
            string problem = table.FindProblem(record.Cube, record.TableOffset, Layout, true) ?? FindCountProblem(table,
                record.PointCount);
            if (problem == null)
                return table;
            table.Dispose();
            throw new PointCloudException(FailureCode.BadInput, path, record.TableOffset, problem);
        }

        void ReadHierarchy()
        {
            string path = SourcePath.Combine(FolderPath, Manifest.HierarchyName);
            using var bytes = StoreFile.ReadWhole(path, StoreFormat.HierarchyMagic, out var header);
            if (header.CloudId != Manifest.CloudId || header.PointCount != Manifest.Points ||
                header.FileBytes != Manifest.HierarchyBytes ||
                header.PlaneCount != Layout.Planes.Count || header.ChunkCount != Manifest.ChunkCount ||
                    header.TableOffset != FileHeader.SizeBytes)
                throw new PointCloudException(FailureCode.BadInput, path, 0, "is not the file that " +
                    StoreFormat.ManifestName + " means");
            // A request less: what is read of a remote file is hashed each time.
            long upperBytes = SourcePath.IsRemote(path) ? Manifest.UpperBytes
                : header.NodeCount == 0 ? 0 : StoreFile.ReadHeader(UpperPath, StoreFormat.UpperMagic).FileBytes;
            if (upperBytes != Manifest.UpperBytes)
                throw PointCloudException.Wanted(FailureCode.BadInput, UpperPath, -1, "size", Manifest.UpperBytes, upperBytes);
            var start = (byte*)bytes.GetUnsafeReadOnlyPtr();
            ulong hash = ContentHash.Of(start, bytes.Length);
            if (hash != Manifest.HierarchyHash)
                throw new PointCloudException(FailureCode.BadInput, path, 0,
                    "is damaged: " + StoreFile.HashProblem(Manifest.HierarchyHash, hash));
            hash = ContentHash.Of(start + FileHeader.SizeBytes, bytes.Length - FileHeader.SizeBytes);
            if (hash != header.TableHash)
                throw new PointCloudException(FailureCode.BadInput, path, FileHeader.SizeBytes,
                    "is damaged: " + StoreFile.HashProblem(header.TableHash, hash));
            var table = bytes.GetSubArray(FileHeader.SizeBytes, bytes.Length - FileHeader.SizeBytes);
            Upper = Take(table, header.NodeCount, header.PlaneCount);
            int chunkBytes = header.ChunkCount * ChunkRecord.SizeBytes;
            var chunks = new NativeArray<ChunkRecord>(header.ChunkCount, Allocator.Persistent);
            UnsafeUtility.MemCpy(chunks.GetUnsafePtr(), start + bytes.Length - chunkBytes, chunkBytes);
            Chunks = chunks;
            string problem = Upper.FindProblem(Manifest.Root, upperBytes, Layout, false) ?? FindChunkProblem();
            if (problem != null)
                throw new PointCloudException(FailureCode.BadInput, path, -1, problem);
        }

        static NodeTable Take(NativeArray<byte> bytes, int nodeCount, int planeCount)
        {
            var nodes = new NativeArray<NodeRecord>(nodeCount, Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
            var planes = new NativeArray<PlaneRange>(nodeCount * planeCount, Allocator.Persistent,
                NativeArrayOptions.UninitializedMemory);
            var start = (byte*)bytes.GetUnsafeReadOnlyPtr();
            long nodeBytes = (long)nodeCount * NodeRecord.SizeBytes;
            UnsafeUtility.MemCpy(nodes.GetUnsafePtr(), start, nodeBytes);
            UnsafeUtility.MemCpy(planes.GetUnsafePtr(), start + nodeBytes, (long)planes.Length * PlaneRange.SizeBytes);
            return new NodeTable(nodes, planes, planeCount);
        }

        static string FindCountProblem(NodeTable table, long points)
        {
            long sum = 0;
            foreach (var node in table.Nodes)
                sum += node.PointCount;
            return sum == points ? null : "wanted " + points + " points in all nodes, got " + sum;
        }

        string FindChunkProblem()
        {
            long points = 0, nodes = Upper.Nodes.Length;
            var numbers = new HashSet<int>();
            int at = 0;
            for (int n = 0; n < Upper.Nodes.Length; n++)
            {
                var node = Upper.Nodes[n];
                points += node.PointCount;
                if (node.ChunkCount < 0 || (node.ChunkCount > 0 && node.FirstChunk != at) || node.ChunkCount > Chunks.Length - at)
                    return "node " + n + ": chunks " + node.FirstChunk + " to " + ((long)node.FirstChunk + node.ChunkCount);
                for (int end = at + node.ChunkCount; at < end; at++)
                {
                    var chunk = Chunks[at];
                    if (chunk.AttachNode != n || chunk.SideLog2 < 0 || chunk.SideLog2 > GridCube.MaxSideLog2 ||
                        !Manifest.Root.Contains(chunk.Cube) || chunk.Number < 0 || !numbers.Add(chunk.Number))
                        return "chunk " + at + ": number " + chunk.Number + " at " + chunk.Cube + " on node " + chunk.AttachNode;
                    points += chunk.PointCount;
                    nodes += chunk.NodeCount;
                }
            }
            if (at != Chunks.Length)
                return "chunks " + at + " and on hang on no node";
            if (nodes != Manifest.NodeCount)
                return "wanted " + Manifest.NodeCount + " nodes, got " + nodes;
            return points == Manifest.Points ? null : "wanted " + Manifest.Points + " points, got " + points;
        }
    }
}
