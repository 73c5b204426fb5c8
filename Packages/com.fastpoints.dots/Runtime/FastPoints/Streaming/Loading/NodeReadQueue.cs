using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Store;
using Unity.Collections;
using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Streaming
{
    // The reads of all clouds. Only a few are in flight at a time, so that the most needed data never waits long. Reads are
    // cancelled when their data is no longer wanted; failed ones are retried, then reported.
    internal sealed unsafe class NodeReadQueue : IDisposable
    {
        public const int FirstPrefetchRank = 1 << 30; // Prefetched nodes rank after all selected ones.

        const int MaxDoublings = 6; // Half a minute.

        readonly StreamState m_state;
        NativeList<SelectedNode> m_wanted = new NativeList<SelectedNode>(1024, Allocator.Persistent);
        long m_count;

        public NodeReadQueue(StreamState state) => m_state = state;

        public List<NodeFetch> Fetches { get; } = new List<NodeFetch>();

        public bool LacksRoom { get; private set; } // Whether the pool had none for what the last frame chose.

        public int InFlightCount
        {
            get
            {
                int count = 0;
                foreach (var fetch in Fetches)
                    count += fetch.Phase != FetchPhase.Idle ? 1 : 0;
                return count;
            }
        }

        public bool IsUsing(StreamedCloud cloud)
        {
            foreach (var fetch in Fetches)
                if (fetch.Phase != FetchPhase.Idle && fetch.Cloud == cloud)
                    return true;
            return false;
        }

        public void Receive(ref FrameStats stats)
        {
            foreach (var fetch in Fetches)
            {
                if (fetch.Phase == FetchPhase.Reading)
                {
                    CancelUnwanted(fetch);
                    if (fetch.TryEndRead(out var status, out long bytes))
                    {
                        stats.ReadBytes += status == ReadStatus.Complete ? bytes : 0;
                        EndRead(fetch, status);
                    }
                }
                if (fetch.Phase == FetchPhase.Transcoding)
                {
                    CancelUnwanted(fetch);
                    if (fetch.TryEndTranscoding(out var outcome, out var failure, out long bytes))
                    {
                        stats.ReadBytes += bytes;
                        EndTranscoding(fetch, outcome, failure);
                    }
                }
                if (fetch.Phase == FetchPhase.Building && fetch.TryEndBuild(out var page, out var problem))
                    EndBuild(fetch, page, problem);
                if (fetch.Phase == FetchPhase.Arrived && !fetch.IsBeingCopied && !HasWaiting(fetch))
                    fetch.End();
            }
        }

        // First the tables that the selection missed, then its missing nodes, then what will be needed soon. It makes room in
        // the pool for each node first.
        public void Request(ref FrameStats stats)
        {
            // All are made at once in the first frame, so that later ones make no garbage.
            while (Fetches.Count < m_state.Settings.MaxReads)
                Fetches.Add(new NodeFetch(m_state));
            int tables = 0;
            foreach (var fetch in Fetches)
                tables += fetch.Phase != FetchPhase.Idle && fetch.IsTable ? 1 : 0;
            RequestTables(m_state.Selector.Missing, NodeFetch.TableRank, ref tables);
            ListWanted(m_state.Selector.Selected);
            bool hasRoom = RequestNodes(0, ref stats);
            LacksRoom = !hasRoom;
            if (!hasRoom)
                return;
            RequestTables(m_state.Selector.MissingOfPrefetch, FirstPrefetchRank, ref tables);
            ListWanted(m_state.Selector.Prefetched);
            RequestNodes(FirstPrefetchRank, ref stats);
        }

        // Of what is foreseen, those of web servers alone: their nodes would come too late otherwise.
        void RequestTables(NativeArray<MissingHierarchyPage> all, int rank, ref int tables)
        {
            foreach (var missing in all)
            {
                var cloud = m_state.Clouds[missing.Cloud];
                var page = cloud.Pages + missing.Page;
                if (rank == FirstPrefetchRank && cloud.Source.RemoteOfTable(missing.Page) == null)
                    continue;
                if (rank == FirstPrefetchRank)
                    page->VisitedFrame = m_state.Selector.Frame;
                if (tables >= MaxTables(missing) || !TryFindIdle(out var fetch))
                    break;
                if (page->Status != HierarchyPageStatus.Absent || !m_state.IsDue(page->RetryFrame) ||
                    FolderReleases.IsReleased(cloud.Source.Path) || !cloud.Source.TryPrepareBuild(missing.Page))
                    continue;
                page->Status = HierarchyPageStatus.Loading;
                fetch.BeginTable(++m_count, cloud, missing.Page, rank);
                tables++;
            }
        }

        // Half of the reads are reserved for nodes; a quarter where a table takes as long as some nodes, and all below waits for
        // it.
        int MaxTables(in MissingHierarchyPage missing)
        {
            int max = m_state.Settings.MaxReads;
            bool isRemote = m_state.Clouds[missing.Cloud].Source.RemoteOfTable(missing.Page) != null;
            return Math.Max(1, isRemote ? max - max / 4 : max / 2);
        }

        // Cancels reads of one cloud, or all if it is null.
        public void Cancel(StreamedCloud cloud)
        {
            foreach (var fetch in Fetches)
                if (fetch.Phase != FetchPhase.Idle && (cloud == null || fetch.Cloud == cloud))
                    fetch.Cancel();
        }

        public void Await()
        {
            foreach (var fetch in Fetches)
                if (fetch.Phase != FetchPhase.Idle)
                    fetch.Abandon();
        }

        public void Dispose()
        {
            foreach (var fetch in Fetches)
                fetch.Dispose();
            Fetches.Clear();
            if (m_wanted.IsCreated)
                m_wanted.Dispose();
        }

        void ListWanted(NativeArray<SelectedNode> nodes) => new ListWantedJob
        {
            Clouds = m_state.CloudPages,
            Nodes = nodes,
            Frame = m_state.Selector.Frame,
            Wanted = m_wanted,
        }.Run();

        // Whether the pool had room for everything requested.
        bool RequestNodes(int firstRank, ref FrameStats stats)
        {
            for (int i = 0; i < m_wanted.Length; i++)
            {
                var first = m_wanted[i];
                // An earlier read has taken it.
                if (first.Node < 0)
                    continue;
                if (!TryFindIdle(out var fetch))
                    return true;
                var cloud = m_state.Clouds[first.Cloud];
                if (FolderReleases.IsReleased(cloud.Source.Path))
                    continue;
                if (cloud.Source.Transcodes(first.Page, first.Node))
                {
                    if (!TryBeginTranscoding(fetch, cloud, first, firstRank, ref stats))
                        return false;
                    continue;
                }
                long bytes = 0;
                bool hasRoom = true;
                for (int j = i; j < m_wanted.Length && hasRoom && bytes < m_state.Settings.MaxBytesPerRead; j++)
                {
                    var node = m_wanted[j];
                    if (node.Node < 0 || node.Cloud != first.Cloud || node.Page != first.Page ||
                        cloud.Source.Transcodes(node.Page, node.Node))
                        continue;
                    long size = cloud.BytesOf(node.Page, node.Node);
                    if (bytes > 0 && bytes + size > m_state.Settings.MaxBytesPerRead)
                        break;
                    hasRoom = m_state.TryAllocateEvicting(node, firstRank + node.Parent, size, ref stats, out int slot);
                    if (!hasRoom)
                        break;
                    if (bytes == 0)
                        fetch.BeginNodes(++m_count, cloud, node.Page);
                    fetch.Add(new FetchedNode { Node = node.Node, Slot = slot, Version = m_state.Cache[slot].Version });
                    bytes += size;
                    stats.RequestedNodes++;
                    m_wanted.ElementAt(j).Node = -1;
                }
                if (bytes > 0)
                    fetch.ReadNodes(m_state.Settings.MaxGapBytes, firstRank + first.Parent);
                stats.RequestedBytes += bytes;
                if (!hasRoom)
                    return false;
            }
            return true;
        }

        // Begins if the source has an idle transcoder. Returns whether the pool had room.
        bool TryBeginTranscoding(NodeFetch fetch, StreamedCloud cloud, SelectedNode node, int firstRank, ref FrameStats stats)
        {
            var transcoder = cloud.Source.TryRentTranscoder(cloud.Pages[node.Page].Nodes[node.Node].PointCount);
            if (transcoder == null)
                return true;
            // The length is only a bound until the node was made once: only then is it known to be too large for any bank.
            var state = cloud.Pages[node.Page].States + node.Node;
            long bytes = cloud.BytesOf(node.Page, node.Node), max = m_state.Pool.BankBytes;
            if (bytes > max && state->WasTranscoded)
            {
                state->Failures = NodeState.HoleFailures;
                m_state.Report(new StreamFailure(cloud.Source.Path, -1,
                    "a node of " + bytes + " bytes, a bank of the pool has " + max));
                cloud.Source.ReturnTranscoder(transcoder);
                return true;
            }
            bytes = Math.Min(bytes, max);
            if (!m_state.TryAllocateEvicting(node, firstRank + node.Parent, bytes, ref stats, out int slot))
            {
                cloud.Source.ReturnTranscoder(transcoder);
                return false;
            }
            var wanted = new FetchedNode { Node = node.Node, Slot = slot, Version = m_state.Cache[slot].Version };
            fetch.BeginTranscoding(++m_count, cloud, node.Page, wanted, transcoder);
            stats.RequestedNodes++;
            stats.RequestedBytes += bytes;
            return true;
        }

        bool TryFindIdle(out NodeFetch idle)
        {
            foreach (var fetch in Fetches)
            {
                idle = fetch;
                if (fetch.Phase == FetchPhase.Idle)
                    return Fetches.Count <= m_state.Settings.MaxReads || InFlightCount < m_state.Settings.MaxReads;
            }
            idle = null;
            return false;
        }

        void CancelUnwanted(NodeFetch fetch)
        {
            if (fetch.IsTable)
            {
                if (m_state.IsUnwanted(fetch.Cloud.Pages[fetch.Page].VisitedFrame))
                    fetch.Cancel();
                return;
            }
            int rank = int.MaxValue;
            foreach (var node in fetch.Nodes)
            {
                if (!m_state.Cache.IsValid(node.Slot, node.Version))
                    continue;
                if (m_state.IsUnwanted(m_state.Cache[node.Slot].UsedFrame))
                    m_state.Release(node.Slot);
                else
                    rank = Math.Min(rank, m_state.Cache[node.Slot].Rank);
            }
            fetch.SetRank(rank);
            if (rank == int.MaxValue)
                fetch.Cancel();
        }

        void EndRead(NodeFetch fetch, ReadStatus status)
        {
            var page = fetch.Cloud.Pages + fetch.Page;
            if (fetch.Cloud.IsRemoving || fetch.IsCancelled)
            {
                Drop(fetch, page);
                return;
            }
            if (status != ReadStatus.Complete)
            {
                var source = fetch.Cloud.Source;
                string path = fetch.ReadToReport.Path;
                var failure = fetch.ReadToReport.RemoteFailure;
                m_state.Files.Close(fetch.Cloud, path);
                Drop(fetch, page);
                if (failure != null)
                {
                    source.MarkStale();
                    CountFailure(page, failure.Path, failure.ByteOffset, failure.What, true);
                    return;
                }
                // The folder of a build was renamed at its end, or deleted: the feed notices within a second.
                if (!source.KeepsFilesOpen && !Directory.Exists(Path.GetDirectoryName(path)))
                    page->RetryFrame = m_state.Selector.Frame + (uint)m_state.Settings.FramesToRetry;
                else
                    CountFailure(page, path, -1, "cannot be read: the read ended as " + status);
                return;
            }
            if (fetch.IsTable)
                fetch.Build();
            else
                page->Failures = 0;
        }

        void EndTranscoding(NodeFetch fetch, TranscodeResult outcome, in StreamFailure failure)
        {
            var page = fetch.Cloud.Pages + fetch.Page;
            var node = fetch.Nodes[0];
            if (fetch.Cloud.IsRemoving || fetch.IsCancelled || !m_state.Cache.IsValid(node.Slot, node.Version))
            {
                Drop(fetch, page);
                return;
            }
            if (outcome == TranscodeResult.Done)
            {
                page->Failures = 0;
                // A node with points outside its cube exceeds its bound: it is requested again with its true length.
                var range = m_state.Cache[node.Slot].Range;
                bool isEmpty = page->Nodes[node.Node].BlockCount == 0;
                if (!isEmpty && m_state.Pool.TryShorten(ref range, fetch.Cloud.BytesOf(fetch.Page, node.Node)))
                    m_state.Cache.SetRange(node.Slot, range);
                else
                    Drop(fetch, page);
                return;
            }
            if (outcome == TranscodeResult.Damaged)
                m_state.DropDamaged(node.Slot, failure);
            Drop(fetch, page);
            if (outcome == TranscodeResult.Unreadable)
                CountFailure(page, failure.Path, failure.OffsetBytes, failure.What);
        }

        void EndBuild(NodeFetch fetch, HierarchyPage built, TableProblem problem)
        {
            var page = fetch.Cloud.Pages + fetch.Page;
            if (fetch.Cloud.IsRemoving)
            {
                if (problem.IsNone)
                    built.Free();
                page->Status = HierarchyPageStatus.Absent;
            }
            else if (problem.IsNone)
            {
                fetch.Cloud.InstallPage(fetch.Page, built, fetch.Table);
            }
            else
            {
                var piece = fetch.Cloud.Source.TableOf(fetch.Page);
                m_state.Files.Close(fetch.Cloud, piece.Path);
                fetch.Cloud.Source.Invalidate(fetch.Page);
                page->Status = HierarchyPageStatus.Absent;
                CountFailure(page, piece.Path, piece.OffsetBytes, fetch.Describe(problem));
            }
            fetch.End();
        }

        // The data are requested again if still wanted.
        void Drop(NodeFetch fetch, HierarchyPage* page)
        {
            if (fetch.IsTable)
                page->Status = HierarchyPageStatus.Absent;
            foreach (var node in fetch.Nodes)
                if (m_state.Cache.IsValid(node.Slot, node.Version))
                    m_state.Release(node.Slot);
            fetch.End();
        }

        // isRemote: it may succeed later, whatever has failed: it is tried again, after ever longer times.
        void CountFailure(HierarchyPage* page, string path, long offset, string what, bool isRemote = false)
        {
            int doublings = isRemote ? math.clamp(page->Failures + 1 - m_state.Settings.MaxTries, 0, MaxDoublings) : 0;
            page->RetryFrame = m_state.Selector.Frame + ((uint)m_state.Settings.FramesToRetry << doublings);
            // Reads of one file that were in flight together fail together: they count as one.
            if (page->LastFailureFrame != 0 && m_state.Selector.Frame - page->LastFailureFrame <
                (uint)m_state.Settings.FramesToRetry)
                return;
            page->LastFailureFrame = m_state.Selector.Frame;
            if (++page->Failures < m_state.Settings.MaxTries)
                return;
            if (isRemote)
            {
                if (page->Failures == m_state.Settings.MaxTries)
                    m_state.Report(new StreamFailure(path, offset, what));
                return;
            }
            if (page->Status == HierarchyPageStatus.Absent)
                page->Status = HierarchyPageStatus.Failed;
            // Reads in flight when the file was given up fail later, and were reported already.
            if (!page->IsBroken)
                m_state.Report(new StreamFailure(path, offset, what));
            page->IsBroken = true;
        }

        bool HasWaiting(NodeFetch fetch)
        {
            for (; fetch.FirstWaiting < fetch.Nodes.Length; fetch.FirstWaiting++)
            {
                var node = fetch.Nodes[fetch.FirstWaiting];
                if (!m_state.Cache.IsValid(node.Slot, node.Version))
                    continue;
                if (!m_state.IsUnwanted(m_state.Cache[node.Slot].UsedFrame))
                    return true;
                m_state.Release(node.Slot);
            }
            return false;
        }
    }
}
