using System;
using FastPoints.Core;
using FastPoints.Drawing;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Picking
{
    /// <summary>Examines one candidate of a search at a time: reads a page's table or a node's planes, or has these made,
    /// searches them in a job and takes the result. Its memory is reused.</summary>
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
        NodeTranscoder m_transcoder;
        bool m_isTranscoding;

        /// <summary>The search of the node that is being made.</summary>
        PickNodeJob m_job;
        int m_classPlane;

        public PickSlot(StreamedCloud cloud)
        {
            m_cloud = cloud;
            m_built = new NativeReference<HierarchyPage>(Allocator.Persistent);
            m_problem = new NativeReference<TableProblem>(Allocator.Persistent);
            m_best = new NativeReference<PickHit>(Allocator.Persistent);
            m_isDamaged = new NativeReference<bool>(Allocator.Persistent);
        }

        /// <summary>The handle to await before the next call.</summary>
        public JobHandle Done { get; private set; }

        NodeSource Source => m_cloud.Source;

        /// <summary>Bytes of what was begun last.</summary>
        public long Bytes { get; private set; }

        /// <summary>Takes a candidate over.</summary>
        /// <returns>False if the node would have to be made while enough are being made already; true if none is.</returns>
        public unsafe bool TryTake(in PickCandidate candidate)
        {
            m_candidate = candidate;
            if (candidate.IsPage || !Source.TranscodesNodes)
                return true;
            m_transcoder = Source.RentTranscoder(m_cloud.Pages[candidate.Page].Nodes[candidate.Node].PointCount);
            return m_transcoder != null;
        }

        /// <summary>Begins to read a page.</summary>
        public void BeginPage()
        {
            Bytes = 0;
            Done = default;
            if (Source.TranscodesNodes)
                return;
            var table = Source.TableOf(m_candidate.Page);
            m_first.Begin(table.Path, table.OffsetBytes, Bytes = table.LengthBytes);
            Done = m_first.Done;
        }

        /// <summary>Continues with what was read or made, if there is more to do. After <see cref="Done"/> it can then be
        /// ended.</summary>
        /// <exception cref="PointCloudException">It cannot be read, or is damaged.</exception>
        public void Continue()
        {
            if (m_candidate.IsPage)
                BuildPage();
            else if (m_transcoder != null)
                SearchTranscoded();
        }

        /// <exception cref="PointCloudException">The table is damaged.</exception>
        public void EndPage()
        {
            Done.Complete();
            if (!m_problem.Value.IsNone)
                throw new PointCloudException(FailureCode.BadInput, Source.PathOf(m_candidate.Page),
                    Source.TableOf(m_candidate.Page).OffsetBytes, Source.Describe(m_candidate.Page, Table, m_problem.Value));
            m_cloud.Load(m_candidate.Page, m_built.Value);
            m_built.Value = default;
        }

        /// <summary>Begins to search a node.</summary>
        /// <param name="classPlane">Index among the streamed planes; used if classes are hidden.</param>
        public unsafe void BeginNode(in PickSpace space, NativeArray<LocalClip> clips, in ClassMask hidden, int classPlane,
            in PickHit best)
        {
            int page = m_candidate.Page, node = m_candidate.Node;
            m_classPlane = hidden.IsEmpty ? StoreLayout.PositionPlane : classPlane;
            m_job = new PickNodeJob
            {
                PositionShape = m_cloud.ShapeOf(page, node, StoreLayout.PositionPlane),
                ClassShape = m_cloud.ShapeOf(page, node, m_classPlane),
                Hidden = hidden,
                BlockCount = m_cloud.Pages[page].Nodes[node].BlockCount,
                IsTranscoded = m_transcoder != null,
                Space = space,
                Clips = clips,
                Step = Source.Grid.Step,
                RootCorner = Source.Root.Corner,
                Place = m_cloud.Pages[page].Places[node],
                Page = page,
                Node = node,
                Best = m_best,
                IsDamaged = m_isDamaged,
            };
            m_best.Value = best;
            if (m_transcoder != null)
                BeginTranscoding();
            else
                BeginReading();
        }

        /// <summary>Returns the node's first hit, or the one that the search began with.</summary>
        /// <exception cref="PointCloudException">It cannot be read, or is damaged.</exception>
        public PickHit EndNode()
        {
            Done.Complete();
            m_first.Complete();
            m_classes.Complete();
            ReturnTranscoder();
            if (m_isDamaged.Value)
                throw new PointCloudException(FailureCode.BadInput, Source.PathOf(m_candidate.Page),
                    m_cloud.RangeOf(m_candidate.Page, m_candidate.Node, StoreLayout.PositionPlane).OffsetBytes,
                    "node " + m_candidate.Node + " is damaged");
            return m_best.Value;
        }

        /// <summary>Awaits unfinished work whose result is no longer wanted.</summary>
        public unsafe void Abandon()
        {
            Done.Complete();
            m_first.Abandon();
            m_classes.Abandon();
            ReturnTranscoder();
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

        NativeArray<byte> Table => Source.TranscodesNodes ? default : m_first.Bytes;

        void BuildPage()
        {
            m_first.Complete();
            Done = Source.ScheduleBuild(m_candidate.Page, Table, m_built, m_problem);
        }

        void BeginReading()
        {
            string path = Source.PathOf(m_candidate.Page);
            var positions = m_cloud.RangeOf(m_candidate.Page, m_candidate.Node, StoreLayout.PositionPlane);
            m_first.Begin(path, positions.OffsetBytes, positions.LengthBytes);
            Bytes = positions.LengthBytes;
            var read = m_first.Done;
            m_job.Positions = m_job.Classes = m_first.Bytes;
            m_job.PositionHash = positions.Hash;
            if (!m_job.Hidden.IsEmpty)
            {
                var classes = m_cloud.RangeOf(m_candidate.Page, m_candidate.Node, m_classPlane);
                m_classes.Begin(path, classes.OffsetBytes, classes.LengthBytes);
                Bytes += classes.LengthBytes;
                read = JobHandle.CombineDependencies(read, m_classes.Done);
                m_job.Classes = m_classes.Bytes;
                m_job.ClassHash = classes.Hash;
            }
            Done = m_job.Schedule(read);
        }

        unsafe void BeginTranscoding()
        {
            m_transcoder.Begin(m_cloud.Pages[m_candidate.Page], m_candidate.Node);
            m_isTranscoding = true;
            Bytes = m_transcoder.BytesRead;
            Done = m_transcoder.Done;
        }

        void SearchTranscoded()
        {
            m_isTranscoding = false;
            m_transcoder.EndOrThrow();
            m_job.Positions = m_transcoder.PlaneOf(StoreLayout.PositionPlane);
            m_job.Classes = m_transcoder.PlaneOf(m_classPlane);
            Done = m_job.Schedule();
        }

        void ReturnTranscoder()
        {
            if (m_isTranscoding)
                m_transcoder.End(out _);
            m_isTranscoding = false;
            if (m_transcoder != null)
                Source.ReturnTranscoder(m_transcoder);
            m_transcoder = null;
        }
    }
}
