using System;
using System.Collections.Generic;
using System.Globalization;
using FastPoints.Base;
using FastPoints.Files;
using FastPoints.Nodes;
using FastPoints.Partition;
using FastPoints.Points;
using FastPoints.Records;
using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Verify
{
    /// <summary>Verifies a stored cloud: every file and table, every hash, every point in its cube, the counts and the checksum.
    /// Compared with its sources, it also proves that the points are the same as a multiset, over position and every
    /// attribute.</summary>
    public sealed unsafe class VerifyCloud : IDisposable
    {
        /// <summary>Nodes that one job takes at a time.</summary>
        const int NodesPerBatch = 1;

        readonly CloudFolder m_folder;
        readonly VerifyResult m_result;
        readonly NativeStoreLayout m_store;
        readonly StoreRead m_read = new StoreRead();

        /// <summary>For each level, sampled points that other chunks' points may be close to.</summary>
        readonly List<NativeList<double3>> m_atSides = new List<NativeList<double3>>();
        ulong m_firstSum;
        ulong m_secondSum;
        long m_nodes;

        VerifyCloud(CloudFolder folder, VerifyResult result)
        {
            m_folder = folder;
            m_result = result;
            m_store = new NativeStoreLayout(folder.Layout);
        }

        /// <summary>Verifies as work for a pump. Problems of the cloud are in the result and throw nothing.</summary>
        /// <param name="against">The sources to compare with; none to skip that.</param>
        /// <exception cref="PointCloudException">The path is not a cloud at all, or a source cannot be read.</exception>
        public static IEnumerator<Work> Run(string path, IReadOnlyList<PointReader> against, VerifyResult result,
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
                yield return Work.Of(verify.CheckFiles(progress));
                yield return Work.Of(verify.MeasureAcrossChunks());
                verify.CheckTotals();
                if (against.Count > 0)
                {
                    progress?.Begin("compare");
                    yield return Work.Of(verify.Compare(against, progress));
                }
                progress?.End();
            }
        }

        public void Dispose()
        {
            foreach (var points in m_atSides)
                points.Dispose();
            m_atSides.Clear();
            m_read.Dispose();
            m_store.Dispose();
        }

        IEnumerator<Work> CheckFiles(StageProgress progress)
        {
            if (m_folder.Upper.Nodes.Length > 0)
            {
                yield return Work.Of(CheckNodes(m_folder.UpperPath, m_folder.Manifest.UpperBytes, m_folder.Upper,
                    m_folder.Manifest.Root, StoreFormat.UpperMagic));
            }
            for (int c = 0; c < m_folder.Chunks.Length; c++)
            {
                NodeTable table = null;
                try
                {
                    table = m_folder.LoadTable(c);
                }
                catch (PointCloudException e)
                {
                    m_result.Add(e.Message);
                }
                if (table == null)
                    continue;
                using (table)
                    yield return Work.Of(CheckNodes(m_folder.ChunkPath(c), m_folder.Chunks[c].FileBytes, table,
                        m_folder.Chunks[c].Cube, StoreFormat.ChunkMagic));
                progress?.Report((c + 1) / (double)m_folder.Chunks.Length, m_result.Points, 0);
            }
        }

        /// <summary>Reads a whole file and checks every node of it.</summary>
        IEnumerator<Work> CheckNodes(string path, long fileBytes, NodeTable table, GridCube cube, ulong magic)
        {
            var spacing = new SpacingCheck(m_folder.Manifest, table, cube, magic == StoreFormat.UpperMagic);
            var verdicts = new NativeArray<NodeCheckResult>(table.Nodes.Length, Allocator.Persistent);
            var job = default(JobHandle);
            try
            {
                bool isRead = false;
                m_read.Begin(path, 0, fileBytes);
                yield return m_read.Done;
                try
                {
                    m_read.Complete();
                    var header = m_read.Bytes.GetSubArray(0, FileHeader.SizeBytes).Reinterpret<FileHeader>(1)[0];
                    string problem = StoreFile.FindProblem(header, magic, fileBytes);
                    if (problem == null && header.CloudId != m_folder.Manifest.CloudId)
                        problem = "is of another cloud";
                    if (problem != null)
                        m_result.Add(path + ": " + problem);
                    isRead = problem == null;
                }
                catch (PointCloudException e)
                {
                    m_result.Add(e.Message);
                }
                if (!isRead)
                    yield break;

                job = new VerifyNodesJob
                {
                    File = m_read.Bytes,
                    Nodes = table.Nodes,
                    Planes = table.Planes,
                    PlaneCount = table.PlaneCount,
                    Columns = m_store.Columns,
                    FirstColumnOfPlane = m_store.FirstColumnOfPlane,
                    Shapes = m_store.Shapes,
                    AverageOf = m_store.AverageOf,
                    AttributeBytes = m_folder.Layout.AttributeBytes,
                    Step = m_folder.Manifest.Grid.Step,
                    Origin = m_folder.Manifest.Root.Corner,
                    FirstSampled = spacing.FirstSampled,
                    Sampled = spacing.Sampled,
                    Results = verdicts,
                }.Schedule(table.Nodes.Length, NodesPerBatch);
                yield return job;
                job.Complete();
                for (int i = 0; i < verdicts.Length; i++)
                    Take(path, i, table, verdicts[i]);
                if (!m_result.Ok)
                    yield break;
                job = spacing.Schedule();
                yield return job;
                job.Complete();
                spacing.Take(m_result.Levels, m_atSides);
            }
            finally
            {
                job.Complete();
                spacing.Dispose();
                verdicts.Dispose();
            }
        }

        void Take(string path, int index, NodeTable table, in NodeCheckResult verdict)
        {
            var node = table.Nodes[index];
            if (verdict.What != NodeCheckResult.Fault.None)
            {
                var range = table.Planes[node.Host * table.PlaneCount + verdict.Plane];
                m_result.Add(string.Format(CultureInfo.InvariantCulture, "{0}: at byte {1}: node {2}, plane \"{3}\": {4}", path,
                    range.OffsetBytes, index, m_folder.Layout.Planes[verdict.Plane].Name, Describe(verdict.What)));
                return;
            }
            m_nodes++;
            m_result.Points += node.PointCount;
            m_firstSum += verdict.FirstSum;
            m_secondSum += verdict.SecondSum;
            int level = m_folder.Manifest.Root.SideLog2 - node.SideLog2;
            while (m_result.Levels.Count <= level)
                m_result.Levels.Add(VerifyResult.Level.None);
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

        /// <summary>Measures how near the sampled points of different chunks are: samplers only keep their distance inside
        /// chunks.</summary>
        IEnumerator<Work> MeasureAcrossChunks()
        {
            var smallest = new NativeReference<double>(Allocator.Persistent);
            var near = new NativeReference<long>(Allocator.Persistent);
            var job = default(JobHandle);
            try
            {
                for (int level = 0; level < m_atSides.Count && m_result.Ok; level++)
                {
                    var at = m_result.Levels[level];
                    job = new CountNearJob
                    {
                        Points = m_atSides[level],
                        Spacing = at.Spacing,
                        MinDistance = smallest,
                        Near = near,
                    }.Schedule();
                    yield return job;
                    job.Complete();
                    at.MinDistanceAcrossChunks = smallest.Value;
                    at.NearAcrossChunks = near.Value;
                    m_result.Levels[level] = at;
                }
            }
            finally
            {
                job.Complete();
                smallest.Dispose();
                near.Dispose();
            }
        }

        static string Describe(NodeCheckResult.Fault fault)
        {
            switch (fault)
            {
                case NodeCheckResult.Fault.PlaneHash: return "is damaged: its hash does not fit";
                case NodeCheckResult.Fault.PlaneShape: return "its blocks do not lie inside it one after the other";
                case NodeCheckResult.Fault.BlockCounts: return "its blocks have other numbers of points than the node";
                case NodeCheckResult.Fault.OutsideCube: return "a point outside of the node's cube";
                case NodeCheckResult.Fault.Bounds: return "the node's bounds are not its points'";
                default: return "a value that its attribute's type cannot have";
            }
        }

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

        IEnumerator<Work> Compare(IReadOnlyList<PointReader> readers, StageProgress progress)
        {
            var manifest = m_folder.Manifest;
            var names = new List<string> { AttributeNames.X, AttributeNames.Y, AttributeNames.Z };
            foreach (var attribute in manifest.Attributes)
                names.Add(attribute.Name);
            long points = 0, leftOut = 0;
            ulong firstSum = 0, secondSum = 0;
            var attributes = new AttributeStatistics[manifest.Attributes.Count];
            for (int a = 0; a < attributes.Length; a++)
                attributes[a] = AttributeStatistics.None;
            foreach (var reader in readers)
            {
                if (!HasAttributes(reader))
                    yield break;
                if (!reader.BlocksAreKnown)
                    yield return Work.Of(reader.FindBlocks());
                var wanted = reader.Info.Schema.Select(names.ToArray());
                using (var sums = new SumPoints(manifest.Attributes, GridChoice.OnGrid(reader.Info, manifest.Grid),
                    reader.MaxPointsPerBlock))
                {
                    yield return Work.Of(SourceScan.Run(reader, wanted, sums, SourceScan.SlotsFor(reader, wanted), progress));
                    var found = sums.TakeStatistics(out ulong second, attributes);
                    points += found.Count;
                    leftOut += found.LeftOut;
                    firstSum += found.Checksum;
                    secondSum += second;
                }
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
                        secondSum,
                    m_firstSum, m_secondSum));
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

    /// <summary>Counts the points that have another one nearer than a spacing, and finds the nearest two.</summary>
    [BurstCompile]
    internal unsafe struct CountNearJob : IJob
    {
        [ReadOnly] public NativeList<double3> Points;
        public double Spacing;

        /// <summary>Out: the smallest distance; infinity for fewer than two points.</summary>
        public NativeReference<double> MinDistance;

        /// <summary>Out: the number of these points.</summary>
        public NativeReference<long> Near;

        public void Execute()
        {
            var points = (double3*)Points.GetUnsafeReadOnlyPtr();
            MinDistance.Value = ClosestPair.Distance(points, Points.Length);
            Near.Value = MinDistance.Value < Spacing ? NearestNeighbours.CountWithin(points, Points.Length, Spacing) : 0;
        }
    }
}
