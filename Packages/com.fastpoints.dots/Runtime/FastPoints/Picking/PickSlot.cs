using System;
using FastPoints.Base;
using FastPoints.Gpu;
using FastPoints.Points;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Picking
{
    /// <summary>One candidate of a search at a time: reads a page's table or a node's planes, has a job look at them, and takes
    /// what
    /// that found. Its memory is used again.</summary>
    sealed class PickSlot : IDisposable
    {
        readonly StreamedCloud m_cloud;
        readonly StoreRead m_first = new StoreRead();
        readonly StoreRead m_classes = new StoreRead();
        NativeReference<HierarchyPage> m_built;
        NativeReference<TableProblem> m_problem;
        NativeReference<PickHit> m_best;
        NativeReference<bool> m_isDamaged;
        PickCandidate m_candidate;

        public PickSlot(StreamedCloud cloud)
        {
            m_cloud = cloud;
            m_built = new NativeReference<HierarchyPage>(Allocator.Persistent);
            m_problem = new NativeReference<TableProblem>(Allocator.Persistent);
            m_best = new NativeReference<PickHit>(Allocator.Persistent);
            m_isDamaged = new NativeReference<bool>(Allocator.Persistent);
        }

        /// <summary>What <see cref="End"/> may be called after.</summary>
        public JobHandle Done { get; private set; }

        /// <summary>Of what was begun last.</summary>
        public long Bytes { get; private set; }

        /// <summary>Begins with a page.</summary>
        public void BeginPage(in PickCandidate candidate)
        {
            m_candidate = candidate;
            var table = m_cloud.Source.TableOf(candidate.Page);
            m_first.Begin(table.Path, table.OffsetBytes, Bytes = table.LengthBytes);
            Done = m_first.Done;
        }

        /// <summary>Goes on with a page whose table was read.</summary>
        public void BuildPage()
        {
            m_first.Complete();
            Done = m_cloud.Source.ScheduleBuild(m_candidate.Page, m_first.Bytes, m_built, m_problem);
        }

        /// <exception cref="PointCloudException">The table is damaged.</exception>
        public void EndPage()
        {
            Done.Complete();
            if (!m_problem.Value.IsNone)
                throw new PointCloudException(FailureCode.BadInput, m_cloud.Source.PathOf(m_candidate.Page),
                    m_cloud.Source.TableOf(m_candidate.Page).OffsetBytes,
                    m_cloud.Source.Describe(m_candidate.Page, m_first.Bytes, m_problem.Value));
            m_cloud.Load(m_candidate.Page, m_built.Value);
            m_built.Value = default;
        }

        /// <summary>Begins with a node.</summary>
        /// <param name="classPlane">Counted among the planes that are streamed; looked at where classes are hidden.</param>
        public unsafe void BeginNode(in PickCandidate candidate, in PickSpace space, NativeArray<LocalClip> clips,
            in ClassMask hidden, int classPlane, in PickHit best)
        {
            m_candidate = candidate;
            int page = candidate.Page, node = candidate.Node;
            string path = m_cloud.Source.PathOf(page);
            var positions = m_cloud.RangeOf(page, node, StoreLayout.PositionPlane);
            m_first.Begin(path, positions.OffsetBytes, positions.LengthBytes);
            Bytes = positions.LengthBytes;
            var read = m_first.Done;
            var job = new PickNodeJob
            {
                Positions = m_first.Bytes,
                PositionShape = m_cloud.ShapeOf(page, node, StoreLayout.PositionPlane),
                PositionHash = positions.Hash,
                Classes = m_first.Bytes,
                BlockCount = m_cloud.Pages[page].Nodes[node].BlockCount,
                Space = space,
                Clips = clips,
                Step = m_cloud.Source.Grid.Step,
                RootCorner = m_cloud.Source.Root.Corner,
                Place = m_cloud.Pages[page].Places[node],
                Page = page,
                Node = node,
                Best = m_best,
                IsDamaged = m_isDamaged,
            };
            if (!hidden.IsEmpty)
            {
                var classes = m_cloud.RangeOf(page, node, classPlane);
                m_classes.Begin(path, classes.OffsetBytes, classes.LengthBytes);
                Bytes += classes.LengthBytes;
                read = JobHandle.CombineDependencies(read, m_classes.Done);
                job.Classes = m_classes.Bytes;
                job.ClassShape = m_cloud.ShapeOf(page, node, classPlane);
                job.ClassHash = classes.Hash;
                job.Hidden = hidden;
            }
            m_best.Value = best;
            Done = job.Schedule(read);
        }

        /// <summary>The node's first hit, or the one that it was begun with.</summary>
        /// <exception cref="PointCloudException">It cannot be read, or is damaged.</exception>
        public PickHit EndNode()
        {
            Done.Complete();
            m_first.Complete();
            m_classes.Complete();
            if (m_isDamaged.Value)
                throw new PointCloudException(FailureCode.BadInput, m_cloud.Source.PathOf(m_candidate.Page),
                    m_cloud.RangeOf(m_candidate.Page, m_candidate.Node, StoreLayout.PositionPlane).OffsetBytes,
                    "node " + m_candidate.Node + " is damaged");
            return m_best.Value;
        }

        /// <summary>Awaits what is under way, which nobody wants any more.</summary>
        public unsafe void Abandon()
        {
            Done.Complete();
            m_first.Abandon();
            m_classes.Abandon();
            if (m_built.Value.Nodes != null)
                m_built.Value.Free();
            m_built.Value = default;
        }

        public void Dispose()
        {
            if (!m_best.IsCreated)
                return;
            Abandon();
            m_first.Dispose();
            m_classes.Dispose();
            m_built.Dispose();
            m_problem.Dispose();
            m_best.Dispose();
            m_isDamaged.Dispose();
        }
    }
}
