using System;
using FastPoints.Store;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Streaming
{
    // One read, from its beginning until its memory can be reused: a page's table, some nodes of one file, whose planes are
    // read in as few pieces as possible, or a node that is transcoded. Main thread; where there are workers, only Abandon waits.
    internal sealed unsafe class NodeFetch : IDisposable
    {
        public const int TableRank = -1; // Before all nodes: none is known until its table is read.

        NativeArray<byte> m_bytes;
        NativeList<FetchPart> m_parts = new NativeList<FetchPart>(256, Allocator.Persistent);
        NativeList<FetchPart> m_sorted = new NativeList<FetchPart>(256, Allocator.Persistent);
        NativeList<FetchedNode> m_nodes = new NativeList<FetchedNode>(64, Allocator.Persistent);

        // Offset of each plane in the read bytes; the index is node * planes + plane.
        NativeList<long> m_offsets = new NativeList<long>(256, Allocator.Persistent);
        NativeReference<HierarchyPage> m_built = new NativeReference<HierarchyPage>(Allocator.Persistent);
        NativeReference<TableProblem> m_problem = new NativeReference<TableProblem>(Allocator.Persistent);
        JobHandle m_building;
        NodeTranscoder m_transcoder;
        long m_readBytes;

        // A table, or planes that the cloud was built with, and planes that were computed later.
        readonly FetchRead m_main;
        readonly FetchRead m_computed;

        public NodeFetch(StreamState state) => (m_main, m_computed) = (new FetchRead(state), new FetchRead(state));

        public FetchPhase Phase { get; private set; }
        public long SequenceNumber { get; private set; }
        public StreamedCloud Cloud { get; private set; }
        public int Page { get; private set; }
        public bool IsTable { get; private set; }
        public bool IsCancelled { get; private set; }

        public int FirstWaiting { get; set; }
        public bool IsBeingCopied { get; set; }

        // The one that failed, if one did.
        public FetchRead ReadToReport => m_main.Status != ReadStatus.Complete ? m_main : m_computed;

        public NativeArray<FetchedNode> Nodes => m_nodes.AsArray();

        public void BeginTable(long sequenceNumber, StreamedCloud cloud, int page, int rank)
        {
            Begin(sequenceNumber, cloud, page, true);
            if (cloud.Source.TranscodesNodes)
            {
                Build();
                return;
            }
            var piece = cloud.Source.TableOf(page);
            Reserve(piece.LengthBytes);
            if (cloud.Source.TryCopyTable(page, m_bytes))
            {
                Build();
                return;
            }
            m_main.Add(piece.OffsetBytes, piece.LengthBytes, 0);
            m_main.Begin(cloud, piece.Path, cloud.Source.RemoteOfTable(page), rank, (byte*)m_bytes.GetUnsafePtr());
            Phase = FetchPhase.Reading;
        }

        // Begins an empty read: Add some nodes, then call ReadNodes.
        public void BeginNodes(long sequenceNumber, StreamedCloud cloud, int page) =>
            Begin(sequenceNumber, cloud, page, false);

        // The transcoder is of the cloud's source; this fetch gives it back.
        public void BeginTranscoding(long sequenceNumber, StreamedCloud cloud, int page, FetchedNode node,
            NodeTranscoder transcoder)
        {
            Begin(sequenceNumber, cloud, page, false);
            m_nodes.Add(node);
            m_transcoder = transcoder;
            transcoder.Begin(cloud.Pages[page], node.Node);
            Phase = FetchPhase.Transcoding;
        }

        public void Add(FetchedNode node)
        {
            for (int p = 0; p < Cloud.Source.Planes.Length; p++)
            {
                var range = Cloud.RangeOf(Page, node.Node, p);
                m_parts.Add(new FetchPart
                {
                    OffsetBytes = range.OffsetBytes,
                    LengthBytes = range.LengthBytes,
                    Node = m_nodes.Length,
                    Plane = p,
                    IsComputed = Cloud.Source.IsComputed(p),
                });
            }
            m_nodes.Add(node);
        }

        // Pieces that are no farther apart than the gap are read as one, but for remote ones, of which that is decided when they
        // are sent for. Of those, the lowest rank comes first.
        public void ReadNodes(int gapBytes, int rank)
        {
            var source = Cloud.Source;
            var remote = source.PlanesRemoteOf(Page);
            if (remote != null)
                gapBytes = 0;
            SortParts();
            m_offsets.ResizeUninitialized(m_parts.Length);
            long total = 0;
            for (int i = 0; i < m_parts.Length; i++)
            {
                var part = m_parts[i];
                total += (part.IsComputed ? m_computed : m_main).Add(part.OffsetBytes, part.LengthBytes, gapBytes);
                m_offsets[part.Node * source.Planes.Length + part.Plane] = total - part.LengthBytes;
            }
            Reserve(total);
            byte* to = m_main.Begin(Cloud, source.PlanesPathOf(Page), remote, rank, (byte*)m_bytes.GetUnsafePtr());
            if (m_parts[m_parts.Length - 1].IsComputed)
                m_computed.Begin(Cloud, source.PathOfComputed(Page), source.RemoteOfComputed(Page), rank, to);
            Phase = FetchPhase.Reading;
        }

        public void SetRank(int rank)
        {
            m_main.SetRank(rank);
            m_computed.SetRank(rank);
        }

        // The read continues until it reports its end.
        public void Cancel()
        {
            if (Phase == FetchPhase.Reading && !IsCancelled)
            {
                m_main.Cancel();
                m_computed.Cancel();
            }
            else if (Phase == FetchPhase.Transcoding)
                m_transcoder.Cancel();
            IsCancelled = true;
        }

        public bool TryEndRead(out ReadStatus status, out long bytes)
        {
            bytes = m_readBytes;
            bool hasEnded = m_main.HasEnded() & m_computed.HasEnded();
            status = ReadToReport.Status;
            if (hasEnded)
                Phase = FetchPhase.Arrived;
            return hasEnded;
        }

        public bool TryEndTranscoding(out TranscodeResult outcome, out StreamFailure failure, out long bytes)
        {
            outcome = default;
            failure = default;
            bytes = 0;
            if (!m_transcoder.TryScheduleDecode() || !JobCoroutine.HasEnded(m_transcoder.Done))
                return false;
            outcome = m_transcoder.End(out failure);
            bytes = m_transcoder.BytesRead;
            if (outcome == TranscodeResult.Done)
                Cloud.SetTranscoded(Page, m_nodes[0].Node, m_transcoder);
            Phase = FetchPhase.Arrived;
            return true;
        }

        // From the table that was read, or from what the source knows.
        public void Build()
        {
            m_building = Cloud.Source.ScheduleBuild(Page, Table, m_built, m_problem);
            Phase = FetchPhase.Building;
        }

        // Whether the page is made or has failed, and this read is free for another.
        public bool TryEndBuild(out HierarchyPage page, out TableProblem problem)
        {
            page = default;
            problem = default;
            if (!JobCoroutine.HasEnded(m_building))
                return false;
            m_building.Complete();
            problem = m_problem.Value;
            page = m_built.Value;
            return true;
        }

        public string Describe(TableProblem problem) => Cloud.Source.Describe(Page, Table, problem);

        public void AddUploadParts(int index, byte* to, int upload, NativeList<UploadPart> parts)
        {
            int node = m_nodes[index].Node;
            byte* transcoded = m_transcoder != null ? (byte*)m_transcoder.Planes.GetUnsafeReadOnlyPtr() : null;
            for (int p = 0; p < Cloud.Source.Planes.Length; p++)
            {
                var range = Cloud.RangeOf(Page, node, p);
                parts.Add(new UploadPart
                {
                    From = m_transcoder != null ? transcoded
                        : (byte*)m_bytes.GetUnsafeReadOnlyPtr() + m_offsets[index * Cloud.Source.Planes.Length + p],
                    Check = m_transcoder != null ? UploadCheck.None
                        : Cloud.Source.IsVerified(Page, node, p) ? UploadCheck.Shape : UploadCheck.Hash,
                    To = to,
                    LengthBytes = range.LengthBytes,
                    Hash = range.Hash,
                    Shape = Cloud.ShapeOf(Page, node, p),
                    BlockCount = Cloud.Pages[Page].Nodes[node].BlockCount,
                    Upload = upload,
                });
                to += range.LengthBytes;
                transcoded += range.LengthBytes;
            }
        }

        public void End()
        {
            Phase = FetchPhase.Idle;
            if (m_transcoder != null)
                Cloud.Source.ReturnTranscoder(m_transcoder);
            m_transcoder = null;
            Cloud = null;
        }

        public void Abandon()
        {
            if (Phase == FetchPhase.Reading)
            {
                m_main.Abandon();
                m_computed.Abandon();
            }
            else if (Phase == FetchPhase.Building)
            {
                m_building.Complete();
                var built = m_built.Value;
                if (m_problem.Value.IsNone)
                    built.Free();
            }
            else if (Phase == FetchPhase.Transcoding)
            {
                m_transcoder.Cancel();
                m_transcoder.End(out _);
            }
            End();
        }

        public void Dispose()
        {
            if (!m_parts.IsCreated)
                return;
            Abandon();
            if (m_bytes.IsCreated)
                m_bytes.Dispose();
            m_main.Dispose();
            m_computed.Dispose();
            m_parts.Dispose();
            m_sorted.Dispose();
            m_nodes.Dispose();
            m_offsets.Dispose();
            m_built.Dispose();
            m_problem.Dispose();
        }

        // Of a page that was read.
        public NativeArray<byte> Table => m_readBytes > 0 ? m_bytes.GetSubArray(0, (int)m_readBytes) : default;

        // By file and offset in it: a stable merge sort.
        void SortParts()
        {
            int count = m_parts.Length;
            m_sorted.ResizeUninitialized(count);
            FetchPart* from = m_parts.GetUnsafePtr(), to = m_sorted.GetUnsafePtr();
            for (int width = 1; width < count; width *= 2)
            {
                for (int begin = 0; begin < count; begin += 2 * width)
                {
                    int middle = Math.Min(begin + width, count), end = Math.Min(begin + 2 * width, count);
                    for (int a = begin, b = middle, at = begin; at < end; at++)
                        to[at] = b >= end || (a < middle && !from[b].IsBefore(from[a])) ? from[a++] : from[b++];
                }
                var swapped = from;
                from = to;
                to = swapped;
            }
            if (from != m_parts.GetUnsafePtr())
                UnsafeUtility.MemCpy(to, from, (long)count * sizeof(FetchPart));
        }

        void Begin(long sequenceNumber, StreamedCloud cloud, int page, bool isTable)
        {
            SequenceNumber = sequenceNumber;
            Cloud = cloud;
            Page = page;
            IsTable = isTable;
            IsCancelled = false;
            FirstWaiting = 0;
            m_readBytes = 0;
            m_main.Clear();
            m_computed.Clear();
            m_parts.Clear();
            m_nodes.Clear();
        }

        void Reserve(long bytes)
        {
            if (!m_bytes.IsCreated || m_bytes.Length < bytes)
            {
                if (m_bytes.IsCreated)
                    m_bytes.Dispose();
                m_bytes = new NativeArray<byte>(checked((int)Math.Max(1 << 16, bytes)), Allocator.Persistent,
                    NativeArrayOptions.UninitializedMemory);
            }
            m_readBytes = bytes;
        }
    }

    internal enum FetchPhase : byte
    {
        Idle,
        Reading,
        Building,
        Transcoding,
        Arrived, // Its nodes wait to be copied into the pool, or are being copied.
    }

    internal struct FetchPart
    {
        public long OffsetBytes;
        public long LengthBytes;
        public int Node;
        public int Plane;
        public bool IsComputed;

        public readonly bool IsBefore(in FetchPart other) =>
            IsComputed != other.IsComputed ? other.IsComputed : OffsetBytes < other.OffsetBytes;
    }

    // Its slot shows whether it is still wanted.
    internal struct FetchedNode
    {
        public int Node;
        public int Slot;
        public int Version;
    }

    // What a fetch reads of one file, here or on a web server, in as few pieces as possible. Main thread.
    internal sealed unsafe class FetchRead : IDisposable
    {
        readonly StreamState m_state;
        NativeList<ReadCommand> m_commands = new NativeList<ReadCommand>(64, Allocator.Persistent);
        ReadHandle m_read;
        RemoteRead m_remote;
        bool m_isReading;

        public FetchRead(StreamState state) => m_state = state;

        public string Path { get; private set; }

        public PointCloudException RemoteFailure { get; private set; }

        public ReadStatus Status { get; private set; }

        public void Clear()
        {
            m_commands.Clear();
            (Path, RemoteFailure, Status) = (null, null, ReadStatus.Complete);
        }

        // Of pieces in the order of their offsets. Those that are no farther apart than the gap are read as one. Returns the
        // bytes that are read more than before; the piece is at their end.
        public long Add(long offset, long bytes, long gap)
        {
            int last = m_commands.Length - 1;
            long lastEnd = last < 0 ? 0 : m_commands[last].Offset + m_commands[last].Size;
            if (last < 0 || offset < lastEnd || offset - lastEnd > gap)
            {
                m_commands.Add(new ReadCommand { Offset = offset, Size = bytes });
                return bytes;
            }
            m_commands.ElementAt(last).Size += offset + bytes - lastEnd;
            return offset + bytes - lastEnd;
        }

        // Returns the end of what is read.
        public byte* Begin(StreamedCloud cloud, string path, RemoteFile remote, int rank, byte* to)
        {
            if (m_commands.Length == 0)
                return to;
            Path = path;
            for (int i = 0; i < m_commands.Length; i++)
            {
                m_commands.ElementAt(i).Buffer = to;
                to += m_commands[i].Size;
            }
            if (remote != null)
                m_remote = remote.Begin(m_commands.GetUnsafePtr(), m_commands.Length, rank);
            else
                m_read = m_state.Files.Read(cloud, path, m_state.Selector.Frame, m_commands.GetUnsafePtr(), m_commands.Length);
            m_isReading = true;
            return to;
        }

        public void SetRank(int rank)
        {
            if (m_remote != null)
                m_remote.Rank = rank;
        }

        // The read continues until it reports its end.
        public void Cancel()
        {
            if (m_remote != null)
                m_remote.Cancel();
            else if (m_isReading)
                m_read.Cancel();
        }

        public bool HasEnded()
        {
            if (!m_isReading)
                return true;
            // Its status is not enough: a read that waits for its file has one that the enum lacks.
            if (m_remote != null ? !m_remote.IsDone : !JobCoroutine.HasEnded(m_read.JobHandle))
                return false;
            if (m_remote != null)
            {
                RemoteFailure = m_remote.Failure;
                Status = m_remote.IsCancelled ? ReadStatus.Canceled : RemoteFailure != null ? ReadStatus.Failed
                    : ReadStatus.Complete;
                m_remote = null;
            }
            else
            {
                m_read.JobHandle.Complete();
                Status = m_read.Status;
                m_read.Dispose();
                m_read = default;
            }
            m_isReading = false;
            return true;
        }

        // Waits for a file of this machine.
        public void Abandon()
        {
            if (m_remote != null)
            {
                m_remote.Cancel();
                m_remote = null;
            }
            else if (m_isReading)
            {
                m_read.JobHandle.Complete();
                m_read.Dispose();
            }
            m_isReading = false;
        }

        public void Dispose() => m_commands.Dispose();
    }
}
