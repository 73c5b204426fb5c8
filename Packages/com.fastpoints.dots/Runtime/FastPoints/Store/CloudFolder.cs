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
        CloudFolder(string path, CloudManifest manifest)
        {
            FolderPath = path;
            Manifest = manifest;
            Layout = manifest.CreateLayout();
        }

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

        public string UpperPath => Path.Combine(FolderPath, Manifest.UpperName);

        public string ChunkPath(int chunk) => Path.Combine(FolderPath, StoreFormat.ChunkPath(Chunks[chunk].Number));

        /// <summary>Whether a path looks like a cloud's folder.</summary>
        public static bool IsCloud(string path) => File.Exists(Path.Combine(Find(path), StoreFormat.ManifestName));

        /// <summary>Finds a cloud under its name, or, if that does not exist yet, its unfinished folder.</summary>
        public static string Find(string path)
        {
            string name = path.TrimEnd(Path.DirectorySeparatorChar, Path.AltDirectorySeparatorChar);
            return Directory.Exists(path) ||
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

        static CloudFolder OpenOnce(string path)
        {
            string manifestPath = Path.Combine(path, StoreFormat.ManifestName);
            var folder = Open(path, CloudManifest.FromJson(StoreFile.ReadText(manifestPath), manifestPath));
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
            if (Chunks.IsCreated)
                Chunks.Dispose();
            Chunks = default;
        }

        /// <summary>The nodes of one chunk; the caller disposes the table.</summary>
        public NodeTable LoadTable(int chunk) => LoadTable(ChunkPath(chunk), Chunks[chunk]);

        // On any thread, even while the folder is disposed.
        internal NodeTable LoadTable(string path, in ChunkRecord record)
        {
            var header = StoreFile.ReadHeader(path, StoreFormat.ChunkMagic);
            if (header.CloudId != Manifest.CloudId || header.Number != record.Number || header.NodeCount != record.NodeCount ||
                header.PointCount != record.PointCount || header.FileBytes != record.FileBytes ||
                    header.PlaneCount != Layout.Planes.Count ||
                header.TableOffset != record.TableOffset || header.TableHash != record.TableHash || header.ChunkCount != 0)
                throw new PointCloudException(FailureCode.BadInput, path, 0, "is not the file that the hierarchy means");
            using var bytes = StoreFile.Read(path, header.TableOffset, header.FileBytes - header.TableOffset,
                Allocator.Persistent);
            ulong hash = ContentHash.Of(bytes.GetUnsafeReadOnlyPtr(), bytes.Length);
            if (hash != header.TableHash)
                throw new PointCloudException(FailureCode.BadInput, path, header.TableOffset,
                    "the node table is damaged: " + StoreFile.HashProblem(header.TableHash, hash));
            var table = Take(bytes, header.NodeCount, header.PlaneCount);
            string problem = table.FindProblem(record.Cube, header.TableOffset, Layout, true) ?? FindCountProblem(table,
                header.PointCount);
            if (problem == null)
                return table;
            table.Dispose();
            throw new PointCloudException(FailureCode.BadInput, path, header.TableOffset, problem);
        }

        void ReadHierarchy()
        {
            string path = Path.Combine(FolderPath, Manifest.HierarchyName);
            var header = StoreFile.ReadHeader(path, StoreFormat.HierarchyMagic);
            if (header.CloudId != Manifest.CloudId || header.PointCount != Manifest.Points ||
                header.FileBytes != Manifest.HierarchyBytes ||
                header.PlaneCount != Layout.Planes.Count || header.ChunkCount != Manifest.ChunkCount ||
                    header.TableOffset != FileHeader.SizeBytes)
                throw new PointCloudException(FailureCode.BadInput, path, 0, "is not the file that " +
                    StoreFormat.ManifestName + " means");
            long upperBytes = header.NodeCount == 0 ? 0 : StoreFile.ReadHeader(UpperPath, StoreFormat.UpperMagic).FileBytes;
            if (upperBytes != Manifest.UpperBytes)
                throw PointCloudException.Wanted(FailureCode.BadInput, UpperPath, -1, "size", Manifest.UpperBytes, upperBytes);
            using (var bytes = StoreFile.Read(path, 0, header.FileBytes, Allocator.Persistent))
            {
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
            }
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
