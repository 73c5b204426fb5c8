using System;
using System.Collections.Generic;
using FastPoints.Points;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Octree
{
    /// <summary>All points of the cloud, by chunk: disjoint cubes of the octree. Owns the records' pages.</summary>
    public sealed class ChunkSet : IDisposable
    {
        const int SplitLevels = 3;

        /// <summary>One chunk.</summary>
        public sealed class Chunk
        {
            public GridCube Cube;
            public RecordPages Pages;
        }

        readonly RecordLayout m_layout;
        readonly List<Chunk> m_chunks = new List<Chunk>();

        public ChunkSet(RecordLayout layout)
        {
            m_layout = layout;
        }

        public IReadOnlyList<Chunk> Chunks => m_chunks;

        /// <summary>Takes over a chunk's records.</summary>
        public void Add(GridCube cube, ref RecordPages pages)
        {
            if (pages.Count > 0)
                m_chunks.Add(new Chunk { Cube = cube, Pages = pages });
            pages = default;
        }

        /// <summary>Work for a pump: takes over the records outside the cube that the root has grown from.</summary>
        /// <param name="shells">The root's doublings, the smallest first.</param>
        /// <param name="outside">Its first element is emptied.</param>
        public IEnumerator<JobHandle> AddOutside(GridCube[] shells, NativeArray<RecordPages> outside)
        {
            var cubes = new NativeArray<GridCube>(shells, Allocator.Persistent);
            var pages = new NativeArray<RecordPages>(shells.Length * 8, Allocator.Persistent);
            var job = default(JobHandle);
            try
            {
                job = new RegroupShellsJob { Pages = outside[0], Layout = m_layout, Shells = cubes, Chunks = pages }.Schedule();
                outside[0] = default;
                yield return job;
                job.Complete();
                for (int i = 0; i < pages.Length; i++)
                    Take(pages, i, shells[i / 8].Child(i % 8));
            }
            finally
            {
                job.Complete();
                FreeAll(pages);
                cubes.Dispose();
            }
        }

        /// <summary>Work for a pump: splits every chunk of more than <paramref name="limit"/> points until none is larger than
        /// that, or all its points are at one place.</summary>
        /// <param name="target">Points of the parts, at most.</param>
        public IEnumerator<JobHandle> SplitLarge(long limit, long target)
        {
            for (int i = 0; i < m_chunks.Count; i++)
            {
                while (m_chunks[i].Pages.Count > limit && m_chunks[i].Cube.SideLog2 > 0)
                {
                    var chunk = m_chunks[i];
                    int before = m_chunks.Count;
                    var split = Split(chunk, target);
                    try
                    {
                        while (split.MoveNext())
                            yield return split.Current;
                    }
                    finally
                    {
                        split.Dispose();
                    }
                    if (m_chunks.Count == before)
                        break;
                    // The parts came to the end; the last takes the place of what they were parts of.
                    m_chunks[i] = m_chunks[m_chunks.Count - 1];
                    m_chunks.RemoveAt(m_chunks.Count - 1);
                }
            }
        }

        /// <summary>Joins chunks that have no more than <paramref name="target"/> points together in a cube, and puts all in
        /// Morton order.</summary>
        public void MergeSmall(GridCube root, long target)
        {
            m_chunks.Sort((a, b) => MortonOrder.Compare(a.Cube.Corner - root.Corner, b.Cube.Corner - root.Corner));
            var merged = new List<Chunk>();
            Merge(root, 0, m_chunks.Count, target, merged);
            m_chunks.Clear();
            m_chunks.AddRange(merged);
        }

        public void Dispose()
        {
            foreach (var chunk in m_chunks)
                chunk.Pages.Free();
            m_chunks.Clear();
        }

        IEnumerator<JobHandle> Split(Chunk chunk, long target)
        {
            var bounds = new NativeArray<Grid3>(2, Allocator.Persistent);
            var counts = default(NativeArray<long>);
            var parts = default(NativeArray<RecordPages>);
            PartitionMap map = null;
            var job = default(JobHandle);
            try
            {
                job = new MeasurePagesJob { Pages = chunk.Pages, Layout = m_layout, Bounds = bounds }.Schedule();
                yield return job;
                job.Complete();
                var cube = RootCube.Shrink(chunk.Cube, bounds[0], bounds[1]);
                chunk.Cube = cube;
                if (cube.SideLog2 == 0)
                    yield break;

                int levels = PartitionMap.LevelsFor(cube.SideLog2, SplitLevels);
                counts = new NativeArray<long>(1 << (3 * levels), Allocator.Persistent);
                var cells = new CellFinder(cube, levels);
                job = new CountCellsJob
                {
                    Pages = chunk.Pages,
                    Layout = m_layout,
                    Cells = cells,
                    PointsOfCell = counts
                }.Schedule();
                yield return job;
                job.Complete();
                map = PartitionMap.Plan(cube, levels, counts, target);
                parts = new NativeArray<RecordPages>(map.Chunks.Length, Allocator.Persistent);
                var pages = chunk.Pages;
                chunk.Pages = default;
                job = new RegroupPagesJob
                {
                    Pages = pages,
                    Layout = m_layout,
                    Cells = cells,
                    ChunkOfCell = map.ChunkOfCell,
                    Chunks = parts,
                }.Schedule();
                yield return job;
                job.Complete();
                for (int i = 0; i < parts.Length; i++)
                    Take(parts, i, map.Chunks[i]);
            }
            finally
            {
                job.Complete();
                if (parts.IsCreated)
                    FreeAll(parts);
                map?.Dispose();
                if (counts.IsCreated)
                    counts.Dispose();
                bounds.Dispose();
            }
        }

        void Merge(GridCube cube, int first, int end, long target, List<Chunk> merged)
        {
            if (end - first <= 1)
            {
                if (end > first)
                    merged.Add(m_chunks[first]);
                return;
            }
            long points = 0;
            for (int i = first; i < end; i++)
                points += m_chunks[i].Pages.Count;
            if (points <= target)
            {
                var all = new Chunk { Cube = cube };
                for (int i = first; i < end; i++)
                    all.Pages.Join(ref m_chunks[i].Pages);
                merged.Add(all);
                return;
            }
            for (int octant = 0; octant < 8; octant++)
            {
                int next = first;
                while (next < end && cube.OctantOf(m_chunks[next].Cube.Corner) == octant)
                    next++;
                Merge(cube.Child(octant), first, next, target, merged);
                first = next;
            }
        }

        void Take(NativeArray<RecordPages> from, int index, GridCube cube)
        {
            var pages = from[index];
            Add(cube, ref pages);
            from[index] = default;
        }

        static void FreeAll(NativeArray<RecordPages> lists)
        {
            for (int i = 0; i < lists.Length; i++)
            {
                var pages = lists[i];
                pages.Free();
            }
            lists.Dispose();
        }
    }
}
