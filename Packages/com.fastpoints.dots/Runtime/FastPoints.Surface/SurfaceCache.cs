using System;
using System.IO;
using System.Runtime.InteropServices;
using FastPoints.Drawing;
using FastPoints.Store;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Surface
{
    /// <summary>Surfaces of cells on disk: beside the cloud, or, where nobody can write there, in a folder of the user. A cell is
    /// found by all that decides on its triangles. Any thread; it waits for the disk.</summary>
    internal sealed class SurfaceCache : IDisposable
    {
        /// <summary>To be raised when the same points make other triangles: what is on disk is then made anew.</summary>
        public const int Version = 1;

        public const string Extension = ".surfaces";
        const int MaxFiles = 16;
        const int KeyLength = 15, EditsAt = 2, CellAt = 13;

        readonly RangeCache m_files;
        readonly ulong[] m_key = new ulong[KeyLength];

        /// <param name="mayWrite">Next to the cloud.</param>
        /// <param name="maxBytes">Of all cells together; those used longest ago go first.</param>
        public SurfaceCache(string cloud, ulong cloudId, bool mayWrite, long maxBytes)
        {
            (m_key[0], m_key[1]) = (Version, cloudId);
            string folder = mayWrite ? Path.ChangeExtension(EditJournal.PathOf(cloud), Extension) : null;
            if (folder == null || !TryCreate(folder))
                folder = RangeCache.FolderOfUser("surfaces");
            m_files = new RangeCache(folder, maxBytes, MaxFiles);
        }

        public string Folder => m_files.Folder;
        public long Bytes => m_files.Bytes;

        /// <summary>What surfaces are made by, before the first is read.</summary>
        public void Begin(in SurfaceGrid grid, ClassMask hidden, double3 metresOfUnit, UpAxis up)
        {
            m_key[3] = math.asulong(grid.VoxelMetres);
            m_key[4] = Pair(grid.CellEdgeVoxels, (int)math.asuint(grid.HoleVoxels));
            for (int i = 0; i < 4; i++)
                m_key[5 + i] = Pair((int)hidden.Low[i], (int)hidden.High[i]);
            for (int axis = 0; axis < 3; axis++)
                m_key[9 + axis] = math.asulong(metresOfUnit[axis]);
            m_key[12] = (ulong)up;
        }

        /// <summary>Not created if there is none, or if it is damaged.</summary>
        /// <param name="edits">Of <see cref="EditPlan.HashIn"/>: those that reach the points that the cell is made of.</param>
        public PackedSurface Read(int3 cell, ulong edits)
        {
            var key = KeyOf(cell, edits);
            var surface = default(PackedSurface);
            surface.Ints = new NativeArray<int>(m_files.LastRangeLength(key) / sizeof(int), Allocator.Persistent,
                NativeArrayOptions.UninitializedMemory);
            if (!m_files.TryRead(key, 0, MemoryMarshal.AsBytes(surface.Ints.AsSpan())) || !surface.IsWhole)
                surface.Dispose();
            return surface;
        }

        public void Write(int3 cell, ulong edits, in PackedSurface surface) =>
            m_files.Add(KeyOf(cell, edits), 0, MemoryMarshal.AsBytes(surface.Ints.AsSpan()));

        /// <summary>What is read or written on other threads meanwhile ends first: nothing waits for it.</summary>
        public void Dispose() => PoolTask.Begin(Folder, () =>
        {
            m_files.Close();
            return true;
        });

        FileVersionKey KeyOf(int3 cell, ulong edits)
        {
            Span<ulong> key = stackalloc ulong[KeyLength];
            m_key.CopyTo(key);
            key[EditsAt] = edits;
            (key[CellAt], key[CellAt + 1]) = (Pair(cell.x, cell.y), (ulong)cell.z);
            ulong first = ContentHash.Of(MemoryMarshal.AsBytes(key));
            key[0] = ~key[0];
            return new FileVersionKey(first, ContentHash.Of(MemoryMarshal.AsBytes(key)));
        }

        static ulong Pair(int low, int high) => (uint)low | (ulong)(uint)high << 32;

        static bool TryCreate(string folder)
        {
            try
            {
                Directory.CreateDirectory(folder);
                return true;
            }
            catch (Exception e) when (e is IOException || e is UnauthorizedAccessException)
            {
                // A disk that cannot be written, or a file of that name.
                return false;
            }
        }
    }

    /// <summary>A converted cloud that surfaces are made of.</summary>
    internal struct OpenedSurface : IDisposable
    {
        public CloudFolder Folder;
        public EditPlan Edits; // Null for the cloud as it is stored.
        public SurfaceCache Cache; // Null for none.

        /// <summary>On a pool thread. Streaming assets are as they were built.</summary>
        public static PoolTask<OpenedSurface> Begin(string path, int cacheMegabytes)
        {
            bool mayWrite = !SourcePath.IsRemote(path) &&
                !path.StartsWith(UnityEngine.Application.streamingAssetsPath, StringComparison.Ordinal);
            return PoolTask.Begin(path, () => Open(path, mayWrite, (long)cacheMegabytes << 20), unwanted => unwanted.Dispose());
        }

        static OpenedSurface Open(string path, bool mayWrite, long cacheBytes)
        {
            var opened = new OpenedSurface { Folder = CloudFolder.IsCloud(path) ? CloudFolder.Open(path) : null };
            try
            {
                if (opened.Folder == null || opened.Folder.IsUnfinished)
                    throw new PointCloudException(FailureCode.Unsupported, path, -1, "colliders are made of whole converted " +
                        "clouds: " + (opened.Folder == null ? "wanted a folder with " + StoreFormat.ManifestName
                        : "this one is still being converted"));
                var manifest = opened.Folder.Manifest;
                opened.Edits = EditPlan.Of(path, manifest);
                if (cacheBytes > 0)
                    opened.Cache = new SurfaceCache(path, manifest.CloudId, mayWrite, cacheBytes);
                return opened;
            }
            catch
            {
                opened.Dispose();
                throw;
            }
        }

        public void Dispose()
        {
            Cache?.Dispose();
            Folder?.Dispose();
        }
    }

    /// <summary>The triangles of a cell in Unity's axes, as they are stored: how many vertices and triangles there are, and
    /// these.</summary>
    internal struct PackedSurface : IDisposable
    {
        const int HeadInts = 2;

        public NativeArray<int> Ints;

        /// <summary>To be filled.</summary>
        public PackedSurface(int vertices, int triangles)
        {
            Ints = new NativeArray<int>(HeadInts + 3 * (vertices + triangles), Allocator.Persistent,
                NativeArrayOptions.UninitializedMemory);
            (Ints[0], Ints[1]) = (vertices, triangles);
        }

        public readonly bool IsWhole => Ints.Length >= HeadInts && Ints[0] >= 0 && Ints[1] >= 0 &&
            Ints.Length == HeadInts + 3 * ((long)Ints[0] + Ints[1]);

        public readonly NativeArray<float3> Vertices => Ints.GetSubArray(HeadInts, 3 * Ints[0]).Reinterpret<float3>(sizeof(int));

        public readonly NativeArray<int3> Triangles =>
            Ints.GetSubArray(HeadInts + 3 * Ints[0], 3 * Ints[1]).Reinterpret<int3>(sizeof(int));

        public void Dispose()
        {
            if (Ints.IsCreated)
                Ints.Dispose();
            Ints = default;
        }
    }
}
