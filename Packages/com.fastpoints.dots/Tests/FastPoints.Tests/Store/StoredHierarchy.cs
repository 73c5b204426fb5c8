using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Build;
using FastPoints.Store;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Tests.Store
{
    /// <summary>A node of a hierarchy that is only a table: no planes are stored.</summary>
    sealed class PlainNode
    {
        public GridCube Cube;
        public bool IsInlined;
        public int PointCount = 1000;
        public readonly List<PlainNode> Children = new List<PlainNode>();
        public readonly List<Subtree> Below = new List<Subtree>(); // The parts that hang on it.

        public PlainNode(GridCube cube) => Cube = cube;

        public PlainNode Add(int octant) => Add(Cube.Child(octant));

        public PlainNode Add(GridCube cube, bool isInlined = false)
        {
            var child = new PlainNode(cube) { IsInlined = isInlined, PointCount = isInlined ? 100 : 1000 };
            Children.Add(child);
            return child;
        }
    }

    /// <summary>The pages of hierarchies that are only tables, written by the writer of converted clouds.</summary>
    static unsafe class StoredHierarchy
    {
        public const ulong CloudId = 0x1234567890ABCDEF;
        public static readonly GridCube Root = new GridCube(default, 40);
        const long PlaneBytes = 1 << 20; // As if each node's planes were the same bytes: of the longest that the tests have.

        /// <param name="roots">Children of a node of the part above, or the root.</param>
        public static Subtree Part(GridCube cube, int planeCount, params PlainNode[] roots)
        {
            var kind = cube.SideLog2 == Root.SideLog2 ? ContainerKind.Upper : ContainerKind.Chunk;
            var subtree = new Subtree
            {
                Cube = cube,
                Container = new ContainerRecord { Cube = cube, Kind = kind, FileBytes = FileHeader.SizeBytes + PlaneBytes },
            };
            var nodes = new List<PlainNode>(roots);
            var records = new List<NodeRecord>();
            foreach (var root in roots)
                records.Add(RecordOf(root, -1, records.Count));
            for (int i = 0; i < nodes.Count; i++)
            {
                var record = records[i];
                record.FirstChild = nodes[i].Children.Count > 0 ? nodes.Count : 0;
                record.ChildCount = nodes[i].Children.Count;
                foreach (var child in nodes[i].Children)
                {
                    var below = RecordOf(child, i, nodes.Count);
                    nodes.Add(child);
                    if (child.IsInlined)
                    {
                        below.FirstBlock = record.PlaneBlocks;
                        record.PlaneBlocks += below.BlockCount;
                    }
                    records.Add(below);
                }
                records[i] = record;
                foreach (var other in nodes[i].Below)
                    subtree.Children.Add((i, other));
            }
            subtree.NodeCount = nodes.Count;
            subtree.Table = new NativeArray<byte>(nodes.Count * ChunkResult.BytesPerNode(planeCount), Allocator.Persistent);
            var table = (NodeRecord*)subtree.Table.GetUnsafePtr();
            var ranges = (PlaneRange*)(table + nodes.Count);
            for (int i = 0; i < nodes.Count; i++)
            {
                table[i] = records[i];
                for (int p = 0; p < planeCount && !nodes[i].IsInlined; p++)
                    ranges[(long)i * planeCount + p] = new PlaneRange
                    {
                        OffsetBytes = FileHeader.SizeBytes,
                        LengthBytes = PlaneBytes,
                        Hash = (ulong)(i * planeCount + p),
                    };
            }
            return subtree;
        }

        static NodeRecord RecordOf(PlainNode node, int parent, int index)
        {
            int blocks = PlaneShape.BlocksOf(node.PointCount);
            uint last = node.Cube.SideLog2 < 32 ? (1u << node.Cube.SideLog2) - 1 : uint.MaxValue;
            return new NodeRecord
            {
                Corner = node.Cube.Corner,
                SideLog2 = (byte)node.Cube.SideLog2,
                CellLog2 = (byte)math.max(0, node.Cube.SideLog2 - 8),
                MaxX = last,
                MaxY = last,
                MaxZ = last,
                Parent = parent,
                PointCount = node.PointCount,
                PlaneNode = node.IsInlined ? parent : index,
                BlockCount = blocks,
                PlaneBlocks = node.IsInlined ? 0 : blocks,
                Flags = node.Children.Count == 0 ? NodeRecord.LeafFlag : (byte)0,
            };
        }

        /// <summary>Writes the pages to the folder's file, and frees the tables.</summary>
        public static CloudManifest Write(string folder, Subtree root, int planeCount)
        {
            var manifest = ManifestFor(planeCount);
            Directory.CreateDirectory(folder);
            using (var file = new FileStream(Path.Combine(folder, StoreFormat.HierarchyName), FileMode.Create))
                Write(manifest, root, _ => throw new InvalidOperationException(), (bytes, offset) =>
                {
                    file.Position = offset;
                    file.Write(bytes.ToArray(), 0, bytes.Length);
                });
            Free(root);
            return manifest;
        }

        /// <summary>Makes pages, and adds what the manifest knows of them.</summary>
        public static void Write(CloudManifest manifest, Subtree root, Action<Subtree> load,
            Action<NativeArray<byte>, long> writePiece)
        {
            IEnumerator<JobStep> Load(Subtree subtree)
            {
                load(subtree);
                yield break;
            }
            IEnumerator<JobStep> WritePiece(NativeArray<byte> bytes, long offset)
            {
                writePiece(bytes, offset);
                yield break;
            }
            using var writer = new HierarchyWriter(manifest.CreateLayout().Planes.Count, CloudId, FileHeader.SizeBytes, Load,
                WritePiece);
            JobCoroutine.RunToEnd(writer.Write(root, link =>
            {
                manifest.Points = link.SubtreePointCount;
                manifest.NodeCount = link.SubtreeNodeCount;
                manifest.RootOffset = link.OffsetBytes;
                manifest.RootBytes = link.LengthBytes;
                manifest.RootHash = link.Hash;
            }));
            manifest.HierarchyFileBytes = writer.Offset;
        }

        public static CloudManifest ManifestFor(int planeCount)
        {
            var attributes = new List<PointAttribute>();
            while (attributes.Count < planeCount - 1)
                attributes.Add(new PointAttribute("a" + attributes.Count, AttributeType.UInt8));
            var divisors = new int[attributes.Count];
            Array.Fill(divisors, 1);
            long last = Root.Side - 1;
            return new CloudManifest
            {
                CloudId = CloudId,
                Grid = new CloudGrid { Step = new double3(0.001, 0.001, 0.001) },
                Root = Root,
                BoundsMax = new Grid3(last, last, last),
                Attributes = new PointSchema(attributes),
                Divisors = divisors,
                Ranges = new CloudManifest.ValueRange[attributes.Count],
            };
        }

        static void Free(Subtree subtree)
        {
            subtree.DisposeTable();
            foreach (var (_, below) in subtree.Children)
                Free(below);
        }
    }
}
