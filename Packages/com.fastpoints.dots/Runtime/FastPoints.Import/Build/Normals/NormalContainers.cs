using System;
using System.Collections.Generic;
using FastPoints.Drawing;
using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Build
{
    /// <summary>The containers of a cloud's normals, beside those of its points: each is in memory from its first normal to its
    /// last, then it is written.</summary>
    internal sealed unsafe class NormalContainers : IDisposable
    {
        readonly CloudFolder m_folder;
        readonly NormalCubes m_cubes;
        readonly ushort m_layer;
        readonly Func<string, NativeArray<byte>, WriteTicket> m_write;
        readonly Dictionary<string, Container> m_containers = new Dictionary<string, Container>();
        readonly List<PlaneRange[]> m_ranges = new List<PlaneRange[]>(); // By page: those of its nodes' normals.
        readonly List<Container> m_containerOfPage = new List<Container>();
        NativeReference<int> m_count;

        sealed class Container
        {
            public ContainerRecord Record;
            public int Points;
            public int Left;

            /// <summary>Nodes with planes of their own, and the first of their points.</summary>
            public readonly List<(int Page, int Node, int First)> Nodes = new List<(int, int, int)>();
            public NativeArray<ushort> Normals;
        }

        /// <param name="write">Queues a file of the cloud's folder.</param>
        public NormalContainers(CloudFolder folder, NormalCubes cubes, ushort layer,
            Func<string, NativeArray<byte>, WriteTicket> write)
        {
            m_folder = folder;
            m_cubes = cubes;
            m_layer = layer;
            m_write = write;
            m_count = new NativeReference<int>(Allocator.Persistent);
        }

        /// <summary>Coroutine, first: a page of the hierarchy a step, which stays with the cubes.</summary>
        public IEnumerator<JobStep> LoadPages()
        {
            for (int page = 0; page < m_folder.PageCount; page++)
            {
                var table = m_cubes.TableAt(page);
                m_ranges.Add(new PlaneRange[table.Nodes.Length]);
                m_containerOfPage.Add(table.Nodes.Length == 0 ? null : Add(page, table));
                yield return default;
            }
        }

        public long Points { get; private set; }

        public long Bytes { get; private set; }

        public PlaneRange RangeOf(int page, int node) => m_ranges[page][node];

        public ContainerRecord ContainerOf(int page) => m_containerOfPage[page].Record;

        Container Add(int page, NodeTable table)
        {
            string path = m_folder.PlanesPathOf(page);
            if (!m_containers.TryGetValue(path, out var container))
            {
                m_containers.Add(path, container = new Container { Record = m_folder.PlanesContainerOf(page) });
                container.Record.Layer = m_layer;
            }
            for (int n = 0; n < table.Nodes.Length; n++)
            {
                if (table.Nodes[n].PlaneNode == n)
                    container.Nodes.Add((page, n, container.Points));
                container.Points = checked(container.Points + table.Nodes[n].PointCount);
            }
            container.Left = container.Points;
            return container;
        }

        /// <summary>Coroutine: takes normals of the chosen nodes' points, in their order, and writes the containers that are
        /// complete.</summary>
        public IEnumerator<JobStep> AppendNormals(NativeArray<ushort> normals)
        {
            int first = 0;
            var complete = new List<Container>();
            foreach (int page in m_cubes.Pages)
            {
                var container = m_containerOfPage[page];
                var nodes = m_cubes.TableOf(page).Nodes;
                if (!container.Normals.IsCreated && container.Left > 0)
                    container.Normals = new NativeArray<ushort>(container.Points, Allocator.Persistent);
                foreach (int n in m_cubes.NodesOf(page))
                {
                    int count = nodes[n].PointCount;
                    if (container.Left > 0)
                    {
                        m_count.Value = 0;
                        yield return JobStep.Of(JobStep.Await(new TakeNormalsJob
                        {
                            From = normals.GetSubArray(first, count),
                            To = container.Normals.GetSubArray(FirstOf(container, page, n, nodes), count),
                            Count = m_count,
                        }.Schedule()));
                        container.Left -= m_count.Value;
                        Points += m_count.Value;
                        if (container.Left == 0)
                            complete.Add(container);
                    }
                    first += count;
                }
            }
            foreach (var container in complete)
                yield return JobStep.Of(Write(container));
        }

        /// <summary>Of a node's points among its container's: those of inlined leaves follow their plane node's.</summary>
        static int FirstOf(Container container, int page, int node, NativeArray<NodeRecord> nodes)
        {
            int planeNode = nodes[node].PlaneNode, low = 0, high = container.Nodes.Count - 1;
            while (low < high)
            {
                int middle = (low + high) / 2;
                var at = container.Nodes[middle];
                if (at.Page < page || at.Page == page && at.Node < planeNode)
                    low = middle + 1;
                else
                    high = middle;
            }
            int first = container.Nodes[low].First;
            if (node == planeNode)
                return first;
            first += nodes[planeNode].PointCount;
            for (int child = nodes[planeNode].FirstChild; child < node; child++)
                first += nodes[child].PlaneNode == planeNode ? nodes[child].PointCount : 0;
            return first;
        }

        IEnumerator<JobStep> Write(Container container)
        {
            using var groups = new NativeList<NormalGroup>(container.Nodes.Count, Allocator.Persistent);
            foreach (var (page, n, first) in container.Nodes)
            {
                var nodes = m_cubes.TableOf(page).Nodes;
                int at = first, begin = groups.Length;
                for (int child = n; child == n || child < nodes[n].FirstChild + nodes[n].ChildCount;
                    child = child == n ? Math.Max(n + 1, nodes[n].FirstChild) : child + 1)
                {
                    if (nodes[child].PlaneNode != n)
                        continue;
                    groups.Add(new NormalGroup { First = at, Count = nodes[child].PointCount });
                    at += nodes[child].PointCount;
                }
                groups.ElementAt(begin).Blocks = nodes[n].PlaneBlocks;
            }
            using var file = new NativeList<byte>(1024, Allocator.Persistent);
            using var ranges = new NativeArray<PlaneRange>(container.Nodes.Count, Allocator.Persistent);
            yield return JobStep.Of(JobStep.Await(new PackNormalsJob
            {
                Groups = groups,
                Normals = container.Normals,
                File = file,
                Ranges = ranges,
            }.Schedule()));
            Complete(container, ranges, file);
            yield return JobStep.Of(CloudFolderWriter.Await(m_write(StoreFormat.PathOf(container.Record), file.AsArray())));
            container.Normals.Dispose();
            container.Normals = default;
        }

        void Complete(Container container, NativeArray<PlaneRange> ranges, NativeList<byte> file)
        {
            for (int i = 0; i < ranges.Length; i++)
                m_ranges[container.Nodes[i].Page][container.Nodes[i].Node] = ranges[i];
            container.Record.FileBytes = file.Length;
            container.Record.Hash = ContentHash.Of(ranges.GetUnsafeReadOnlyPtr(), (long)ranges.Length * sizeof(PlaneRange));
            Bytes += file.Length;
            var header = new FileHeader
            {
                Magic = StoreFormat.PlanesMagic,
                Version = StoreFormat.Version,
                PlaneCount = 1,
                Container = container.Record,
                PointCount = container.Points,
                CloudId = m_folder.Manifest.CloudId,
            };
            header.HeaderHash = StoreFile.HashOf(header);
            *(FileHeader*)file.GetUnsafePtr() = header;
        }

        /// <summary>Throws where a point has got no normal, nor been found to have none.</summary>
        public void CheckComplete()
        {
            foreach (var container in m_containers.Values)
                if (container.Left != 0)
                    throw new PointCloudException(FailureCode.BadInput, m_folder.FolderPath, -1, container.Left +
                        " points of " + StoreFormat.PathOf(container.Record) + " are in no cube of their nodes");
        }

        public void Dispose()
        {
            if (!m_count.IsCreated)
                return;
            m_count.Dispose();
            foreach (var container in m_containers.Values)
                if (container.Normals.IsCreated)
                    container.Normals.Dispose();
        }
    }

    internal struct NormalGroup
    {
        public int First;
        public int Count;
        public int Blocks; // Of the plane that begins with it; 0 for inlined leaves.
    }

    [BurstCompile]
    internal struct TakeNormalsJob : IJob
    {
        [ReadOnly] public NativeArray<ushort> From;
        public NativeArray<ushort> To;
        public NativeReference<int> Count;

        public void Execute()
        {
            int count = 0;
            for (int i = 0; i < From.Length; i++)
            {
                if (From[i] == OctahedralNormal.Unset)
                    continue;
                To[i] = From[i];
                count++;
            }
            Count.Value = count;
        }
    }

    [BurstCompile]
    internal unsafe struct PackNormalsJob : IJob
    {
        [ReadOnly] public NativeList<NormalGroup> Groups;
        [ReadOnly] public NativeArray<ushort> Normals;
        public NativeList<byte> File; // Out: the file, with room for its header, and by plane node its range.
        public NativeArray<PlaneRange> Ranges;

        public void Execute()
        {
            var shape = new PlaneShape(2, 0);
            File.Resize(FileHeader.SizeBytes, NativeArrayOptions.ClearMemory);
            for (int group = 0, plane = 0; group < Groups.Length; plane++)
            {
                int end = group + 1, points = Groups[group].Count;
                for (; end < Groups.Length && Groups[end].Blocks == 0; end++)
                    points += Groups[end].Count;
                int start = File.Length, blocks = Groups[group].Blocks;
                File.ResizeUninitialized(start + (int)shape.MaxBytes(blocks, points));
                var writer = new BlockWriter((uint*)(File.GetUnsafePtr() + start), shape, 0,
                    (long)blocks * shape.DescriptorWords);
                for (; group < end; group++)
                    Write(Groups[group], ref writer);
                int length = (int)writer.End();
                Ranges[plane] = new PlaneRange
                {
                    OffsetBytes = start,
                    LengthBytes = length,
                    Hash = ContentHash.Of(writer.Plane, length),
                };
                File.ResizeUninitialized(start + length);
            }
        }

        void Write(in NormalGroup group, ref BlockWriter writer)
        {
            ulong* values = stackalloc ulong[PlaneShape.MaxColumns * PlaneShape.MaxPointsPerBlock];
            ulong* min = stackalloc ulong[PlaneShape.MaxColumns];
            ulong* max = stackalloc ulong[PlaneShape.MaxColumns];
            var normals = (ushort*)Normals.GetUnsafeReadOnlyPtr() + group.First;
            for (int first = 0; first < group.Count; first += PlaneShape.MaxPointsPerBlock)
            {
                int count = System.Math.Min(PlaneShape.MaxPointsPerBlock, group.Count - first);
                for (int i = 0; i < count; i++)
                {
                    BlockWriter.NarrowOf(values, 0)[i] = (uint)normals[first + i] & 0xFF;
                    BlockWriter.NarrowOf(values, 1)[i] = (uint)normals[first + i] >> 8;
                }
                writer.Write(values, count, min, max);
            }
        }
    }
}
