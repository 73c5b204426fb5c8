using System;
using System.Collections.Generic;
using System.Globalization;
using FastPoints.Nodes;
using FastPoints.Reading;
using FastPoints.Store;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Export
{
    /// <summary>Verifies a converted cloud: every file and page, every hash, every point in its cube, the counts and the
    /// checksum. Compared with its sources, it also proves that the points are the same as a multiset, over position and every
    /// attribute.</summary>
    public sealed class VerifyCloud : IDisposable
    {
        /// <summary>Memory of the files in flight, unless one takes more: enough for half a second's work of a worker.</summary>
        const long MaxBytes = 96L << 20;

        const int MaxTablesInFlight = 8;

        readonly CloudFolder m_folder;
        readonly VerifyResult m_result;
        readonly NativeStoreLayout m_store;

        ulong m_firstSum;
        ulong m_secondSum;
        long m_nodes;

        VerifyCloud(CloudFolder folder, VerifyResult result)
        {
            m_folder = folder;
            m_result = result;
            m_store = new NativeStoreLayout(folder.Layout);
        }

        /// <summary>Verifies as a coroutine. Problems of the cloud are in the result and throw nothing.</summary>
        /// <param name="against">The sources to compare with; none to skip that.</param>
        /// <exception cref="PointCloudException">The path is not a cloud at all, or a source cannot be read.</exception>
        public static IEnumerator<JobStep> Run(string path, IReadOnlyList<PointReader> against, VerifyResult result,
            StageProgress progress)
        {
            if (!CloudFolder.IsCloud(path))
                throw new PointCloudException(FailureCode.NotFound, path, -1, "no cloud: wanted a folder with " +
                    StoreFormat.ManifestName);
            CloudFolder folder;
            try
            {
                folder = CloudFolder.Open(path);
            }
            catch (PointCloudException e)
            {
                result.Add(e.Message);
                yield break;
            }
            result.IsBuilding = folder.Manifest.IsBuilding;
            using (folder)
            using (var verify = new VerifyCloud(folder, result))
            {
                progress?.Begin("verify");
                yield return JobStep.Of(verify.CheckPages(progress));
                yield return JobStep.Of(verify.CheckHeaders());
                verify.CheckTotals();
                if (against.Count > 0)
                {
                    progress?.Begin("compare");
                    yield return JobStep.Of(verify.Compare(against, progress));
                }
                progress?.End();
            }
        }

        public void Dispose() => m_store.Dispose();

        IEnumerator<JobStep> CheckPages(StageProgress progress)
        {
            var tables = new Queue<PoolTask<NodeTable>>();
            var inFlight = new Queue<(PageCheck Check, string Problem)>();
            PageCheck next = null;
            int page = 0, requested = 1, done = 0;
            long bytes = 0;
            try
            {
                while (done < m_folder.PageCount)
                {
                    for (; requested < m_folder.PageCount && tables.Count < MaxTablesInFlight; requested++)
                        tables.Enqueue(m_folder.BeginPage(requested));
                    if (next == null && page < m_folder.PageCount && (page == 0 || tables.Peek().IsDone))
                    {
                        try
                        {
                            var table = page == 0 ? m_folder.Root : tables.Dequeue().Take();
                            m_folder.Register(page, table.View);
                            next = new PageCheck(m_folder, page, m_store, table);
                        }
                        catch (PointCloudException e)
                        {
                            inFlight.Enqueue((null, e.Message));
                        }
                        page++;
                    }
                    if (next != null && (inFlight.Count == 0 || bytes + next.Bytes <= MaxBytes))
                    {
                        var begun = next;
                        inFlight.Enqueue((begun, null));
                        next = null;
                        bytes += begun.Bytes;
                        yield return JobStep.Of(begun.Begin());
                        continue;
                    }
                    if (inFlight.Count == 0)
                    {
                        yield return default;
                        continue;
                    }
                    var (oldest, problem) = inFlight.Peek();
                    if (problem != null)
                    {
                        m_result.Add(problem);
                    }
                    else
                    {
                        yield return oldest.Jobs;
                        Add(oldest);
                        bytes -= oldest.Bytes;
                        oldest.Dispose();
                    }
                    inFlight.Dequeue();
                    done++;
                    progress?.Report(m_result.Points / Math.Max(1.0, m_folder.Manifest.Points), m_result.Points, 0);
                    // What was freed took milliseconds, as the next check's memory does.
                    yield return default;
                }
            }
            finally
            {
                next?.Dispose();
                foreach (var (check, _) in inFlight)
                    check?.Dispose();
                foreach (var table in tables)
                    table.Dispose();
            }
        }

        /// <summary>Coroutine: the heads of all files that the pages named. Those of a web server are not read by anybody
        /// else.</summary>
        IEnumerator<JobStep> CheckHeaders()
        {
            var files = new List<(string Path, long Bytes)>(m_folder.Files());
            string hierarchy = m_folder.TableOf(0).Path;
            foreach (var (path, bytes) in files)
                if (m_folder.RemoteOfTable(0) == null)
                    yield return JobStep.Of(PoolTask.Run(path, () => FindProblem(path, bytes,
                        path == hierarchy ? StoreFormat.HierarchyMagic : StoreFormat.PlanesMagic), problem =>
                    {
                        if (problem != null)
                            m_result.Add(problem);
                    }));
        }

        /// <returns>What is wrong with the head of a file, or null. Any thread.</returns>
        string FindProblem(string path, long bytes, ulong magic)
        {
            try
            {
                using var head = StoreFile.Read(path, 0, FileHeader.SizeBytes, Allocator.Persistent);
                long size = StoreFile.SizeOf(path);
                string problem = size != bytes ? "wanted " + bytes + " bytes, got " + size
                    : StoreFile.FindProblem(head.Reinterpret<FileHeader>(1)[0], magic, m_folder.Manifest.CloudId, size);
                return problem == null ? null : path + ": " + problem;
            }
            catch (PointCloudException e)
            {
                return e.Message;
            }
        }

        void Add(PageCheck check)
        {
            try
            {
                check.End();
            }
            catch (PointCloudException e)
            {
                m_result.Add(e.Message);
                return;
            }
            int node = 0;
            foreach (var result in check.NodeResults())
                AddNode(check.Path, node++, check.Table, result);
        }

        void AddNode(string path, int index, NodeTable table, in NodeCheckResult result)
        {
            var node = table.Nodes[index];
            if (result.Fault != NodeFault.None)
            {
                var range = table.PlaneRanges[node.PlaneNode * table.PlaneCount + result.Plane];
                m_result.Add(string.Format(CultureInfo.InvariantCulture, "{0}: at byte {1}: node {2}, plane \"{3}\": {4}", path,
                    range.OffsetBytes, index, m_folder.Layout.Planes[result.Plane].Name, Describe(result, range)));
                return;
            }
            m_nodes++;
            m_result.Points += node.PointCount;
            m_firstSum += result.FirstSum;
            m_secondSum += result.SecondSum;
            int level = m_folder.Manifest.Root.SideLog2 - node.SideLog2;
            while (m_result.Levels.Count <= level)
                m_result.Levels.Add(default);
            var at = m_result.Levels[level];
            at.Nodes++;
            at.Points += node.PointCount;
            if (node.HasSpacing)
            {
                at.SampledPoints += node.PointCount;
                double spacing = math.cmin(m_folder.Manifest.Grid.Step) * math.pow(2.0, node.CellLog2);
                at.Spacing = at.Spacing == 0 ? spacing : Math.Min(at.Spacing, spacing);
            }
            m_result.Levels[level] = at;
        }

        static string Describe(in NodeCheckResult result, in PlaneRange range) => result.Fault switch
        {
            NodeFault.PlaneHash => "is damaged: " + StoreFile.HashProblem(range.Hash, result.Hash),
            NodeFault.PlaneShape => "its blocks do not lie inside it one after the other",
            NodeFault.BlockCounts => "its blocks have other numbers of points than the node",
            NodeFault.OutsideCube => "a point outside of the node's cube",
            NodeFault.Bounds => "the node's bounds are not its points'",
            _ => "a value that its attribute's type cannot have",
        };

        void CheckTotals()
        {
            var manifest = m_folder.Manifest;
            if (!m_result.Ok)
                return;
            if (m_result.Points != manifest.Points || m_nodes != manifest.NodeCount)
            {
                m_result.Add(string.Format(CultureInfo.InvariantCulture, "{0}: wanted {1} points in {2} nodes, got {3} in {4}",
                    m_folder.FolderPath, manifest.Points, manifest.NodeCount, m_result.Points, m_nodes));
            }
            if (m_firstSum != manifest.Checksum)
            {
                m_result.Add(string.Format(CultureInfo.InvariantCulture,
                    "{0}: checksum of all points: wanted {1:x16}, got {2:x16}",
                    m_folder.FolderPath, manifest.Checksum, m_firstSum));
            }
        }

        IEnumerator<JobStep> Compare(IReadOnlyList<PointReader> readers, StageProgress progress)
        {
            var manifest = m_folder.Manifest;
            long points = 0, leftOut = 0;
            ulong firstSum = 0, secondSum = 0;
            foreach (var reader in readers)
            {
                if (!HasAttributes(reader))
                    yield break;
                if (!reader.BlocksAreKnown)
                    yield return JobStep.Of(reader.IndexBlocks());
                var wanted = reader.Info.Schema.SelectWithPosition(manifest.Attributes);
                using var sums = new PointSetHash(manifest.Attributes, GridChoice.OnGrid(reader.Info, manifest.Grid),
                    reader.MaxPointsPerBlock);
                yield return JobStep.Of(SourceScan.Run(reader, wanted, sums, SourceScan.SlotsFor(reader, wanted), progress));
                var found = sums.CollectStatistics(out ulong second);
                points += found.Count;
                leftOut += found.LeftOut;
                firstSum += found.Checksum;
                secondSum += second;
            }
            if (points != manifest.Points || leftOut != manifest.PointsLeftOut)
            {
                m_result.Add(string.Format(CultureInfo.InvariantCulture,
                    "against the sources: wanted {0} points and {1} left out, got {2} and {3}", points, leftOut, manifest.Points,
                    manifest.PointsLeftOut));
            }
            else if (m_result.Ok && (firstSum != m_firstSum || secondSum != m_secondSum))
            {
                m_result.Add(string.Format(CultureInfo.InvariantCulture,
                    "against the sources: the points are not the same: hash sums {0:x16}{1:x16}, got {2:x16}{3:x16}", firstSum,
                    secondSum, m_firstSum, m_secondSum));
            }
        }

        bool HasAttributes(PointReader reader)
        {
            foreach (var attribute in m_folder.Manifest.Attributes)
            {
                int column = reader.Info.Schema.IndexOf(attribute.Name);
                if (column >= 0 && reader.Info.Schema[column].Equals(attribute))
                    continue;
                m_result.Add(reader.Info.Path + ": wanted the attribute " + attribute + ", got " +
                    (column < 0 ? "none" : reader.Info.Schema[column].ToString()));
                return false;
            }
            return true;
        }
    }

    /// <summary>The result of verifying a converted cloud.</summary>
    public sealed class VerifyResult
    {
        /// <summary>Statistics of one level of the octree.</summary>
        public struct Level
        {
            public int Nodes;
            public long Points;

            /// <summary>Edge of the finest sampling cells of the level's nodes in CRS units; 0 if all are leaves.</summary>
            public double Spacing;

            /// <summary>Number of points in nodes that have a spacing: neither leaves nor chains at one place.</summary>
            public long SampledPoints;
        }

        /// <summary>Whether the cloud is still being built, so that only finished parts were verified.</summary>
        public bool IsBuilding;

        public const int MaxProblems = 100;

        readonly List<string> m_problems = new List<string>();

        /// <summary>The first <see cref="MaxProblems"/> problems, one line each.</summary>
        public IReadOnlyList<string> Problems => m_problems;
        public bool Ok => ProblemCount == 0;
        public int ProblemCount { get; private set; }

        /// <summary>Number of points that were read and found correct.</summary>
        public long Points;

        /// <summary>Statistics of each level; level 0 has the root's cube.</summary>
        public readonly List<Level> Levels = new List<Level>();

        public void Add(string problem)
        {
            ProblemCount++;
            if (m_problems.Count < MaxProblems)
                m_problems.Add(problem);
        }
    }
}
