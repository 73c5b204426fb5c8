using System;
using System.Collections.Generic;
using FastPoints.Store;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Streaming
{
    /// <summary>The source of a cloud's folder, finished or not; then of the generation that was opened.</summary>
    public sealed class FolderSource : NodeSource
    {
        readonly CloudFolder m_folder;
        readonly HierarchyGrid m_grid;
        readonly string[] m_pathOfPage; // Made once: a new path for each read would be garbage.
        NativeArray<int> m_planes;
        NativeArray<PlaneShape> m_shapes;

        /// <summary>Owns the folder. Streams the position and the named planes, as far as the cloud has them.</summary>
        public FolderSource(CloudFolder folder, params string[] planes)
        {
            m_folder = folder;
            m_grid = new HierarchyGrid(folder.Manifest);
            m_pathOfPage = new string[1 + folder.Chunks.Length];
            m_pathOfPage[0] = folder.UpperPath;
            for (int chunk = 0; chunk < folder.Chunks.Length; chunk++)
                m_pathOfPage[1 + chunk] = folder.ChunkPath(chunk);
            var wanted = new SortedSet<int> { StoreLayout.PositionPlane };
            foreach (string name in planes)
                if (folder.Layout.PlaneOf(name) >= 0)
                    wanted.Add(folder.Layout.PlaneOf(name));
            var indices = new int[wanted.Count];
            wanted.CopyTo(indices);
            m_planes = new NativeArray<int>(indices, Allocator.Persistent);
            m_shapes = folder.Layout.CreateShapes(Allocator.Persistent);
        }

        /// <summary>Opens a folder with all planes except averages: two small files, on any thread.</summary>
        public static FolderSource OpenWhole(string path)
        {
            var folder = CloudFolder.Open(path);
            var names = new List<string>();
            foreach (var plane in folder.Layout.Planes)
                if (plane.AverageOf < 0)
                    names.Add(plane.Name);
            return new FolderSource(folder, names.ToArray());
        }

        /// <summary>The cloud that is streamed.</summary>
        public CloudFolder Folder => m_folder;

        public override string Path => SourcePath.WithoutQuery(m_folder.FolderPath);
        public override CloudCrs Crs => m_folder.Manifest.Crs;
        public override bool HasAllPoints => !m_folder.IsUnfinished;
        public override CloudGrid Grid => m_folder.Manifest.Grid;
        public override GridCube Root => m_folder.Manifest.Root;
        public override NodeCubes Cubes => new NodeCubes { Size = Root.Side * Grid.Step, Step = Grid.Step };
        public override StoreLayout Layout => m_folder.Layout;
        public override NativeArray<int> Planes => m_planes;
        public override NativeArray<PlaneShape> Shapes => m_shapes;
        public override int PageCount => m_pathOfPage.Length;

        public override unsafe void CreatePages(HierarchyPage* pages)
        {
            for (int chunk = 0; chunk < m_folder.Chunks.Length; chunk++)
                pages[1 + chunk] = HierarchyPage.OfChunk(m_folder.Chunks[chunk], m_grid);
            pages[0] = default;
            HierarchyPageBuilding.Build(m_folder.Upper.View, m_planes, m_grid, pages + 1, ref pages[0]);
        }

        internal override bool KeepsFilesOpen => !m_folder.IsUnfinished;

        public override string PathOf(int page) => m_pathOfPage[page];

        internal override bool IsChecked(int page, int node, int plane) =>
            m_folder.Checked != null && m_folder.Checked.Has(page, node, m_planes[plane]);

        internal override void SetChecked(int page, int node, int plane) => m_folder.Checked?.Add(page, node, m_planes[plane]);

        internal override void Distrust(int page)
        {
            m_folder.Checked?.Forget(page);
            RemoteOf(page)?.DropCached();
            Doubt();
        }

        internal override RemoteFile RemoteOf(int page) => m_folder.RemoteOf(page);

        internal override double RoundTrip => m_folder.RemoteOf(0)?.RoundTrip ?? 0;

        internal override void Doubt() => Doubted?.Invoke();

        // Set by whoever would open it again.
        internal Action Doubted { get; set; }

        internal override FilePiece TableOf(int page)
        {
            var chunk = m_folder.Chunks[page - 1];
            return new FilePiece
            {
                Path = m_pathOfPage[page],
                OffsetBytes = chunk.TableOffset,
                LengthBytes = chunk.NodeCount * (NodeRecord.SizeBytes + (long)m_shapes.Length * PlaneRange.SizeBytes),
            };
        }

        public override JobHandle ScheduleBuild(int page, NativeArray<byte> table, NativeReference<HierarchyPage> built,
            NativeReference<TableProblem> problem) => JobFor(page, table, built, problem).Schedule();

        public override string Describe(int page, NativeArray<byte> table, TableProblem problem) =>
            NodeTable.Describe(problem, JobFor(page, table, default, default).Check);

        public override IEnumerator<JobStep> OpenForPicking(Action<NodeSource> opened)
        {
            string path = m_folder.FolderPath;
            return PoolTask.Run<FolderSource>(path, () => OpenWhole(path), opened, unwanted => unwanted.Dispose());
        }

        public override void Dispose()
        {
            m_folder.Dispose();
            if (!m_planes.IsCreated)
                return;
            m_planes.Dispose();
            m_shapes.Dispose();
        }

        BuildHierarchyPageJob JobFor(int page, NativeArray<byte> table, NativeReference<HierarchyPage> built,
            NativeReference<TableProblem> problem) => new BuildHierarchyPageJob
            {
                Table = table,
                Chunk = m_folder.Chunks[page - 1],
                Grid = m_grid,
                Shapes = m_shapes,
                Wanted = m_planes,
                Built = built,
                Problem = problem,
            };
    }
}
