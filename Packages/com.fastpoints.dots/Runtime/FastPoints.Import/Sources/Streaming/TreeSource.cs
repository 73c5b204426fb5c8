using System;
using System.Collections.Generic;
using FastPoints.Reading;
using FastPoints.Sampling;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Jobs;
using Unity.Jobs.LowLevel.Unsafe;

namespace FastPoints.Sources
{
    /// <summary>A file or folder with an octree (COPC, Potree, EPT), streamed without conversion. Its hierarchy is read as deep
    /// as it is viewed; its nodes are decoded and packed on demand. It also streams a preview's sample
    /// (<see cref="SampleReader"/>).</summary>
    public sealed class TreeSource : NodeSource
    {
        const int MaxTranscoders = 16; // Begun and not yet taken: a transcoder is free again in the frame after its last job.
        const int MinBusyTranscoders = 2; // Large ones: one is read while another is decoded.

        // Begun for each worker, except for single nodes: about 50 ms of work, enough until the next frame, at 30 Hz as well.
        const int PointsPerWorker = 1 << 18;
        const int MaxPoints = 1 << 21; // The same for all workers: a point at work takes some 60 bytes.

        readonly TreePages m_pages;
        readonly TreePlanes m_planes;
        readonly List<TreeNodeTranscoder> m_transcoders = new List<TreeNodeTranscoder>(MaxTranscoders);
        readonly List<TreeNodeTranscoder> m_idle = new List<TreeNodeTranscoder>(MaxTranscoders);
        readonly TranscoderChain[] m_chains;
        readonly long m_maxPoints;
        long m_pointsInFlight;
        TreePlanes m_allPlanes;
        NativeArray<PlaneShape> m_shapes;

        /// <param name="reader">The reader, which this source owns, after <see cref="ReadTop"/>.</param>
        /// <param name="planes">Names of planes that are streamed besides the position (<see cref="StoreLayout"/>); those that
        /// the source lacks are left out.</param>
        /// <exception cref="PointCloudException">The source has no octree, or one without a root.</exception>
        public TreeSource(PointReader reader, params string[] planes)
        {
            if (reader.Tree == null)
                throw new PointCloudException(FailureCode.Unsupported, reader.Info.Path, -1,
                    "brings no octree along: wanted COPC, Potree or EPT, got " + reader.Info.Format);
            Reader = reader;
            TreeGrid = new TreeGrid(reader.Info, reader.Tree);
            m_pages = new TreePages(reader, TreeGrid);
            m_chains = new TranscoderChain[Math.Max(1, JobsUtility.JobWorkerCount)];
            for (int i = 0; i < m_chains.Length; i++)
                m_chains[i] = new TranscoderChain();
            // What is on its way from a server occupies no worker.
            m_maxPoints = reader.IsRemote ? MaxPoints : Math.Min(MaxPoints, (long)PointsPerWorker * m_chains.Length);
            Layout = TreePlanes.LayoutOf(reader.Info.Schema);
            m_planes = new TreePlanes(reader.Info.Schema, Layout, planes);
            m_shapes = Layout.CreateShapes(Allocator.Persistent);
        }

        public PointReader Reader { get; }

        public override string Path => SourcePath.WithoutQuery(Reader.Info.Path);
        public override bool HasAllPoints => !(Reader is SampleReader sample) || sample.HasAllPoints;
        public override CloudGrid Grid => TreeGrid.Grid;
        public override GridCube Root => TreeGrid.Root;
        public override NodeCubes Cubes => TreeGrid.Cubes;
        public override StoreLayout Layout { get; }
        public override CloudCrs Crs => Reader.Info.Crs.ToCloudCrs();
        public override NativeArray<int> Planes => m_planes.Indices;
        public override NativeArray<PlaneShape> Shapes => m_shapes;
        public override int PageCount => m_pages.Count;
        public override bool TranscodesNodes => true;

        internal TreeGrid TreeGrid { get; }

        /// <summary>Coroutine, needed before a source is made: reads the upper levels of the hierarchy.</summary>
        /// <exception cref="PointCloudException">They cannot be read.</exception>
        public static IEnumerator<JobStep> ReadTop(PointReader reader) => reader.ReadLevels(TreePages.LevelsToKnow);

        public override unsafe void CreatePages(HierarchyPage* pages)
        {
            using (var built = new NativeReference<HierarchyPage>(Allocator.TempJob))
            using (var problem = new NativeReference<TableProblem>(Allocator.TempJob))
            {
                var job = JobFor(0, built, problem);
                job.Run();
                pages[0] = built.Value;
            }
            RegisterPage(0, pages[0], default);
        }

        public override string PlanesPathOf(int page) => Path;

        internal override FilePiece TableOf(int page) => new FilePiece { Path = Path };

        public override bool TryPrepareBuild(int page) => m_pages.RequestPage(page);

        public override JobHandle ScheduleBuild(int page, NativeArray<byte> table, NativeReference<HierarchyPage> built,
            NativeReference<TableProblem> problem) => m_pages.Schedule(JobFor(page, built, problem));

        public override string Describe(int page, NativeArray<byte> table, TableProblem problem) => "its hierarchy is damaged";

        public override void RegisterPage(int page, in HierarchyPage built, NativeArray<byte> table) =>
            m_pages.Number(page, built, m_planes.Count);

        public override HierarchyPage EmptyPage(int page) => m_pages.CreateEmpty(page);

        public override PointCloudException Update() => m_pages.Update();

        internal override bool IsReading => m_pages.IsReading;

        public override JobHandle Reading => m_pages.Step;

        public override NodeTranscoder TryRentTranscoder(int points)
        {
            int busy = m_transcoders.Count - m_idle.Count;
            if (busy == MaxTranscoders || busy >= MinBusyTranscoders && m_pointsInFlight + points > m_maxPoints)
                return null;
            int best = BestIdle(points);
            if (best < 0)
            {
                m_transcoders.Add(new TreeNodeTranscoder(Reader, TreeGrid, m_planes, Planes.Length));
                m_idle.Add(m_transcoders[m_transcoders.Count - 1]);
                best = m_idle.Count - 1;
            }
            var transcoder = m_idle[best];
            m_idle.RemoveAt(best);
            var chain = m_chains[0];
            foreach (var other in m_chains)
                chain = other.Points < chain.Points ? other : chain;
            transcoder.Join(chain, points);
            m_pointsInFlight += points;
            return transcoder;
        }

        public override void ReturnTranscoder(NodeTranscoder transcoder)
        {
            var given = (TreeNodeTranscoder)transcoder;
            m_pointsInFlight -= given.LeaveChain();
            m_idle.Add(given);
        }

        public override NodeTranscoder CreateFullTranscoder()
        {
            var names = new List<string>();
            foreach (var plane in Layout.Planes)
                names.Add(plane.Name);
            m_allPlanes ??= new TreePlanes(Reader.Info.Schema, Layout, names);
            return new TreeNodeTranscoder(Reader, TreeGrid, m_allPlanes, Planes.Length);
        }

        public override IEnumerator<JobStep> OpenForPicking(Action<NodeSource> opened)
        {
            PointReader reader = (Reader as SampleReader)?.TryDuplicate();
            if (Reader is SampleReader && reader == null)
                yield break;
            try
            {
                string path = Reader.Info.Path;
                if (reader == null)
                    yield return JobStep.Of(PoolTask.Run(path, () => PointReaders.Open(path), other => reader = other,
                        other => other.DisposeUnread()));
                yield return JobStep.Of(ReadTop(reader));
                var source = new TreeSource(reader, AttributeNames.Classification);
                reader = null;
                opened(source);
            }
            finally
            {
                reader?.Dispose();
            }
        }

        public override void Dispose()
        {
            if (!m_shapes.IsCreated)
                return;
            foreach (var transcoder in m_transcoders)
                transcoder.Dispose();
            m_pages.Dispose();
            m_planes.Dispose();
            m_allPlanes?.Dispose();
            m_shapes.Dispose();
            Reader.Dispose();
        }

        // The smallest with enough memory, otherwise the largest, so that few grow large; -1 if none is idle.
        int BestIdle(int points)
        {
            int best = -1;
            for (int i = 0; i < m_idle.Count; i++)
            {
                int capacity = m_idle[i].Capacity, ofBest = best < 0 ? 0 : m_idle[best].Capacity;
                bool isBetter = ofBest >= points ? capacity >= points && capacity < ofBest : capacity > ofBest;
                if (best < 0 || isBetter)
                    best = i;
            }
            return best;
        }

        BuildTreePageJob JobFor(int page, NativeReference<HierarchyPage> built, NativeReference<TableProblem> problem)
        {
            var job = m_pages.JobFor(page);
            job.BitsOfPlane = m_planes.Bits;
            job.Shapes = m_planes.Shapes;
            job.Built = built;
            job.Problem = problem;
            return job;
        }
    }
}
