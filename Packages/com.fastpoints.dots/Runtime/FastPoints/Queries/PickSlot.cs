using System;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Queries
{
    // Examines one candidate of a search at a time: reads a page's table or a node's planes, or transcodes them, searches them
    // in a job and takes the result. Its memory is reused.
    sealed class PickSlot : IDisposable
    {
        readonly StreamedCloud m_cloud;
        readonly StoreRead m_first = new StoreRead();
        readonly StoreRead m_classes = new StoreRead();
        readonly StoreRead m_normals = new StoreRead();
        NativeReference<HierarchyPage> m_built = new NativeReference<HierarchyPage>(Allocator.Persistent);
        NativeReference<TableProblem> m_problem = new NativeReference<TableProblem>(Allocator.Persistent);
        NativeReference<HitTotals> m_totals = new NativeReference<HitTotals>(Allocator.Persistent);
        NativeArray<PickHit> m_hits;
        NativeReference<bool> m_isDamaged = new NativeReference<bool>(Allocator.Persistent);
        PickCandidate m_candidate;
        NodeTranscoder m_transcoder;
        bool m_isTranscoding;
        PickNodeJob m_job; // Of the node that is transcoded.
        int m_classPlane;
        int m_normalPlane;
        JobHandle m_done;

        public PickSlot(StreamedCloud cloud) => m_cloud = cloud;

        // To await before the next call.
        public JobHandle Done
        {
            get => m_isTranscoding ? m_transcoder.Done : m_done;
            private set => m_done = value;
        }

        NodeSource Source => m_cloud.Source;

        // Returns whether all bytes have arrived, so that Done covers the decoding too. A remote node's decoding is started
        // from here.
        public bool TryContinueReads() =>
            m_first.IsFetched && m_classes.IsFetched && m_normals.IsFetched &&
            (!m_isTranscoding || m_transcoder.TryScheduleDecode());

        // Whether Continue has something to do when it is.
        public bool HasMore => m_candidate.IsPage || m_isTranscoding || Source.PlanesRemoteOf(m_candidate.Page) != null;

        public long Bytes { get; private set; }

        // False if the node needs a transcoder and all are busy.
        public unsafe bool TryTake(in PickCandidate candidate)
        {
            m_candidate = candidate;
            if (candidate.IsPage || !Source.Transcodes(candidate.Page, candidate.Node))
                return true;
            m_transcoder = Source.TryRentTranscoder(m_cloud.Pages[candidate.Page].Nodes[candidate.Node].PointCount);
            return m_transcoder != null;
        }

        public void BeginPage()
        {
            Bytes = 0;
            Done = default;
            if (Source.TranscodesNodes)
                return;
            var table = Source.TableOf(m_candidate.Page);
            m_first.Begin(table.Path, table.OffsetBytes, Bytes = table.LengthBytes,
                Source.RemoteOfTable(m_candidate.Page));
            Done = m_first.Done;
        }

        // Schedules what follows the read, if anything. Call End after Done.
        public void Continue()
        {
            if (m_candidate.IsPage)
                BuildPage();
            else if (m_transcoder != null)
                SearchTranscoded();
            else if (Source.PlanesRemoteOf(m_candidate.Page) != null)
                SearchFetched();
        }

        public void EndPage()
        {
            Done.Complete();
            if (!m_problem.Value.IsNone)
            {
                var table = Source.TableOf(m_candidate.Page);
                throw new PointCloudException(FailureCode.BadInput, table.Path, table.OffsetBytes,
                    Source.Describe(m_candidate.Page, Table, m_problem.Value));
            }
            m_cloud.InstallPage(m_candidate.Page, m_built.Value, Table);
            m_built.Value = default;
        }

        // The job is the search's own, but for what it says of this node. The planes of classes and normals are indices among
        // the streamed ones.
        public unsafe void BeginNode(in PickNodeJob search, int classPlane, int normalPlane, int maxHits)
        {
            int page = m_candidate.Page, node = m_candidate.Node;
            m_classPlane = search.Hidden.IsEmpty ? StoreLayout.PositionPlane : classPlane;
            m_normalPlane = search.HasNormals ? normalPlane : StoreLayout.PositionPlane;
            if (m_hits.Length != maxHits || !m_hits.IsCreated)
            {
                if (m_hits.IsCreated)
                    m_hits.Dispose();
                m_hits = new NativeArray<PickHit>(maxHits, Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
            }
            m_job = search;
            m_job.PositionShape = m_cloud.ShapeOf(page, node, StoreLayout.PositionPlane);
            m_job.ClassShape = m_cloud.ShapeOf(page, node, m_classPlane);
            m_job.NormalShape = m_cloud.ShapeOf(page, node, m_normalPlane);
            m_job.BlockCount = m_cloud.Pages[page].Nodes[node].BlockCount;
            m_job.IsTranscoded = m_transcoder != null;
            m_job.Address = m_cloud.Pages[page].Addresses[node];
            m_job.Page = page;
            m_job.Node = node;
            m_job.Hits = m_hits;
            m_job.Totals = m_totals;
            m_job.IsDamaged = m_isDamaged;
            if (m_transcoder != null)
                BeginTranscoding();
            else
                BeginReading();
        }

        public unsafe void EndNode(ref HitHeap hits)
        {
            Done.Complete();
            m_first.Complete();
            m_classes.Complete();
            TryCompleteNormals();
            ReturnTranscoder();
            if (m_isDamaged.Value)
                throw new PointCloudException(FailureCode.BadInput, Source.PlanesPathOf(m_candidate.Page),
                    m_cloud.RangeOf(m_candidate.Page, m_candidate.Node, StoreLayout.PositionPlane).OffsetBytes,
                    "node " + m_candidate.Node + " is damaged");
            hits.Add((PickHit*)m_hits.GetUnsafeReadOnlyPtr(), m_totals.Value);
        }

        public unsafe void Abandon()
        {
            if (!m_totals.IsCreated)
                return;
            Done.Complete();
            m_first.Abandon();
            m_classes.Abandon();
            m_normals.Abandon();
            ReturnTranscoder();
            if (m_built.Value.Nodes != null)
                m_built.Value.Free();
            m_built.Value = default;
        }

        public void Dispose()
        {
            if (!m_totals.IsCreated)
                return;
            Abandon();
            m_first.Dispose();
            m_classes.Dispose();
            m_normals.Dispose();
            m_built.Dispose();
            m_problem.Dispose();
            m_totals.Dispose();
            if (m_hits.IsCreated)
                m_hits.Dispose();
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
            string path = Source.PlanesPathOf(m_candidate.Page);
            var remote = Source.PlanesRemoteOf(m_candidate.Page);
            var positions = m_cloud.RangeOf(m_candidate.Page, m_candidate.Node, StoreLayout.PositionPlane);
            m_first.Begin(path, positions.OffsetBytes, positions.LengthBytes, remote);
            Bytes = positions.LengthBytes;
            var read = m_first.Done;
            m_job.Positions = m_job.Classes = m_job.Normals = m_first.Bytes;
            m_job.PositionHash = positions.Hash;
            if (!m_job.Hidden.IsEmpty)
            {
                var classes = m_cloud.RangeOf(m_candidate.Page, m_candidate.Node, m_classPlane);
                m_classes.Begin(path, classes.OffsetBytes, classes.LengthBytes, remote);
                Bytes += classes.LengthBytes;
                read = JobHandle.CombineDependencies(read, m_classes.Done);
                m_job.Classes = m_classes.Bytes;
                m_job.ClassHash = classes.Hash;
            }
            if (m_job.HasNormals)
            {
                var normals = m_cloud.RangeOf(m_candidate.Page, m_candidate.Node, m_normalPlane);
                m_normals.Begin(Source.PathOfComputed(m_candidate.Page), normals.OffsetBytes, normals.LengthBytes,
                    Source.RemoteOfComputed(m_candidate.Page));
                Bytes += normals.LengthBytes;
                read = JobHandle.CombineDependencies(read, m_normals.Done);
                m_job.Normals = m_normals.Bytes;
                m_job.NormalHash = normals.Hash;
            }
            Done = remote != null ? default : m_job.Schedule(read);
        }

        // Throws if not all has come.
        void SearchFetched()
        {
            m_first.Complete();
            m_classes.Complete();
            m_job.HasNormals &= TryCompleteNormals();
            Done = m_job.Schedule();
        }

        // A hit is one without its normal, too.
        bool TryCompleteNormals()
        {
            try
            {
                m_normals.Complete();
                return true;
            }
            catch (PointCloudException)
            {
                return false;
            }
        }

        unsafe void BeginTranscoding()
        {
            m_transcoder.Begin(m_cloud.Pages[m_candidate.Page], m_candidate.Node);
            m_isTranscoding = true;
            Bytes = m_transcoder.BytesRead;
        }

        void SearchTranscoded()
        {
            m_isTranscoding = false;
            m_transcoder.EndOrThrow();
            int points = 0;
            m_transcoder.CorrectCounts(ref m_job.BlockCount, ref points);
            m_job.Positions = m_transcoder.PlaneOf(StoreLayout.PositionPlane);
            m_job.Classes = m_transcoder.PlaneOf(m_classPlane);
            m_job.Normals = m_transcoder.PlaneOf(m_normalPlane);
            Done = m_job.Schedule();
        }

        void ReturnTranscoder()
        {
            if (m_isTranscoding)
            {
                m_transcoder.Cancel();
                m_transcoder.End(out _);
            }
            m_isTranscoding = false;
            if (m_transcoder != null)
                Source.ReturnTranscoder(m_transcoder);
            m_transcoder = null;
        }
    }
}
