using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using FastPoints.Store;
using NUnit.Framework;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Tests.Store
{
    /// <summary>Damage that hashes do not show: they are made right again, up to that in cloud.json.</summary>
    public unsafe class TableCheckTests : FolderTests
    {
        const int PlaneCount = 2;
        const int Mutations = 5000;

        byte[] m_bytes;
        CloudManifest m_manifest;
        readonly List<StoredPage> m_pages = new List<StoredPage>();

        struct StoredPage
        {
            public PageLink Link;
            public int Above; // The page that links to it.
            public long LinkAt; // In the file.
        }

        public delegate void Damage(PlantedPage page);

        /// <summary>A page in memory.</summary>
        public readonly struct PlantedPage
        {
            readonly byte* m_bytes;

            public PlantedPage(byte* bytes) => m_bytes = bytes;

            PageView View => new PageView { Bytes = m_bytes };

            internal ref PageHeader Header => ref *(PageHeader*)m_bytes;

            internal ref ContainerRecord Container => ref View.Containers[0];

            public ref int ContainerOfPlane(int plane) => ref View.ContainerOfPlane[plane];

            public ref NodeRecord Node(int node) => ref View.Nodes[node];

            internal ref PageLink Link(int link) => ref View.Links[link];

            internal ref PackedRange Range(int node, int plane) => ref View.Ranges[node * PlaneCount + plane];
        }

        // Page 0: the root; node 1 has three inlined leaves and a leaf, node 2 a leaf; on node 8 hang two parts. Page 1: one of
        // them.
        [SetUp]
        public void Write()
        {
            var root = new PlainNode(StoredHierarchy.Root);
            for (int i = 0; i < 8; i++)
                root.Add(i);
            for (int i = 0; i < 3; i++)
                root.Children[0].Add(root.Children[0].Cube.Child(i), true);
            root.Children[0].Add(3);
            root.Children[1].Add(3);
            foreach (int octant in new[] { 2, 5 })
            {
                var chunk = new PlainNode(root.Children[7].Cube.Child(octant));
                for (int i = 0; i < 4; i++)
                    chunk.Add(i).Add(i);
                root.Children[7].Below.Add(StoredHierarchy.Part(chunk.Cube, PlaneCount, chunk.Children.ToArray()));
            }
            var subtree = StoredHierarchy.Part(StoredHierarchy.Root, PlaneCount, root);
            m_manifest = StoredHierarchy.Write(Folder.Path, subtree, PlaneCount);
            m_bytes = File.ReadAllBytes(HierarchyPath);
            m_pages.Clear();
            using var folder = CloudFolder.Open(Folder.Path, m_manifest);
            m_pages.Add(new StoredPage { Link = folder.LinkOf(0) });
            int page = 0;
            foreach (var table in folder.EachTable())
            {
                for (int l = 0; l < table.Links.Length; l++)
                    m_pages.Add(new StoredPage
                    {
                        Link = table.Links[l],
                        Above = page,
                        LinkAt = m_pages[page].Link.OffsetBytes + table.View.Header.LinksOffset + l * PageLink.SizeBytes,
                    });
                page++;
            }
            Assert.That(m_pages.Count, Is.EqualTo(3));
        }

        string HierarchyPath => Path.Combine(Folder.Path, StoreFormat.HierarchyName);

        static IEnumerable<TestCaseData> Faults()
        {
            yield return Fault(TableFault.Head, 0, p => p.Header.Version++, "version");
            yield return Fault(TableFault.Head, 0, p => p.Header.CloudId++, "cloud");
            yield return Fault(TableFault.Head, 0, p => p.Header.NodeCount = int.MaxValue, "more nodes");
            yield return Fault(TableFault.Head, 0, p => p.Header.LinkCount = -1, "links");
            yield return Fault(TableFault.Head, 1, p => p.Container.SideLog2 = -1, "container");
            yield return Fault(TableFault.Head, 1, p => p.Container.Kind = (ContainerKind)4, "kind");
            yield return Fault(TableFault.Head, 1, p => p.ContainerOfPlane(1) = 1, "plane's container");
            yield return Fault(TableFault.Roots, 0, p => p.Node(1).Parent = -1);
            yield return Fault(TableFault.Orphans, 1, p =>
            {
                p.Node(7).Parent = -1;
                p.Node(3).ChildCount = p.Node(3).FirstChild = 0;
            });
            yield return Fault(TableFault.Link, 0, p => p.Link(1).AttachNode = 7, "node");
            yield return Fault(TableFault.Link, 0, p => p.Link(1).OffsetBytes = p.Link(1).LengthBytes = 0, "length");
            yield return Fault(TableFault.Link, 0, p => p.Link(1).LengthBytes = StoreFormat.MaxPageBytesToRead, "too long");
            yield return Fault(TableFault.Link, 0, p => p.Link(1).OffsetBytes += 1 << 20, "behind this page");
            yield return Fault(TableFault.Link, 0, p => p.Link(1).OffsetBytes = 0, "in the header");
            yield return Fault(TableFault.Link, 0, p => p.Link(1).Container = 1, "container");
            yield return Fault(TableFault.Link, 0, p =>
            {
                p.Link(1).Container = 0;
                p.Link(1).OffsetBytes = p.Container.FileBytes;
            }, "end of container");
            yield return Fault(TableFault.Link, 0, p => p.Link(1).SubtreePointCount = 1L << 62, "points");
            yield return Fault(TableFault.Link, 0, p => p.Link(1).SubtreeNodeCount = long.MaxValue, "nodes");
            yield return Fault(TableFault.Link, 0, p => p.Link(1).SideLog2 = 41, "cube");
            yield return Fault(TableFault.Link, 0, p => p.Link(1).Corner.X++, "cube not of octree");
            yield return Fault(TableFault.Link, 0, p =>
            {
                p.Header.NodeCount = 0;
                p.Header.LinkCount = (int)((p.Header.LengthBytes - p.Header.LinksOffset) / PageLink.SizeBytes);
            }, "of no node", TableFault.Head);
            yield return Fault(TableFault.Links, 0, p => p.Node(8).LinkCount = 3);
            yield return Fault(TableFault.Links, 0, p => p.Node(8).FirstLink = 1, "first");
            yield return Fault(TableFault.PointSum, 1, p => p.Header.PointCount++, "own");
            yield return Fault(TableFault.PointSum, 0, p => p.Link(0).SubtreePointCount++, "too many");
            yield return Fault(TableFault.PointSum, 0, p => p.Link(0).SubtreePointCount--, "too few");
            yield return Fault(TableFault.NodeSum, 0, p => p.Link(0).SubtreeNodeCount++, "too many");
            yield return Fault(TableFault.NodeSum, 0, p => p.Link(0).SubtreeNodeCount--, "too few");
            yield return Fault(TableFault.Side, 1, p => p.Node(2).SideLog2 = 63);
            yield return Fault(TableFault.Side, 1, p => p.Node(2).CellLog2 = 62, "cells");
            yield return Fault(TableFault.OutsideRegion, 1, p => p.Node(2).Corner.X = -1);
            yield return Fault(TableFault.NotOfOctree, 1, p => p.Node(2).Corner.X++);
            yield return Fault(TableFault.Parent, 1, p => p.Node(6).Parent = 6);
            yield return Fault(TableFault.Parent, 1, p => p.Node(6).Parent = -2, "below -1");
            yield return Fault(TableFault.ParentCube, 1, p => p.Node(6).Corner = p.Node(0).Corner);
            yield return Fault(TableFault.ParentCube, 1, p =>
            {
                p.Node(6).Corner = p.Node(2).Corner;
                p.Node(6).SideLog2 = p.Node(2).SideLog2;
            }, "the same");
            yield return Fault(TableFault.NotAChild, 0, p => p.Node(9).Parent = 0);
            yield return Fault(TableFault.Children, 1, p => p.Node(2).FirstChild++);
            yield return Fault(TableFault.Children, 1, p => p.Node(2).ChildCount = 7, "count");
            yield return Fault(TableFault.PointCount, 1, p => p.Node(2).PointCount = 0);
            yield return Fault(TableFault.PointCount, 1, p => p.Node(2).PointCount = StoreFormat.MaxPointsPerNode + 1, "many");
            yield return Fault(TableFault.BlockCount, 1, p => p.Node(2).BlockCount++);
            yield return Fault(TableFault.Bounds, 1, p => (p.Node(2).MinY, p.Node(2).MaxY) = (1, 0));
            yield return Fault(TableFault.InlinedLeaf, 0, p => p.Node(10).PlaneBlocks = 1);
            yield return Fault(TableFault.InlinedLeaf, 1, p => p.Node(2).PlaneNode = 0, "not the parent");
            yield return Fault(TableFault.FirstBlock, 1, p => p.Node(2).FirstBlock = 1);
            yield return Fault(TableFault.InlinedBlocks, 0, p => p.Node(10).FirstBlock++);
            yield return Fault(TableFault.PlaneBlocks, 1, p => p.Node(2).PlaneBlocks++);
            yield return Fault(TableFault.InlinedPlane, 0, p => p.Range(10, 1) = p.Range(0, 1));
            yield return Fault(TableFault.Plane, 1, p => p.Range(2, 1).OffsetAndLength = 0);
            yield return Fault(TableFault.Plane, 1, p => p.Range(2, 0).OffsetAndLength = ulong.MaxValue, "behind the end");
        }

        static TestCaseData Fault(TableFault fault, int page, Damage damage, string what = "",
            TableFault found = TableFault.None) => new TestCaseData(found == TableFault.None ? fault : found, page, damage)
                .SetName("Load_RightHash_FindsFault(" + fault + (what == "" ? "" : ", " + what) + ")");

        [TestCaseSource(nameof(Faults))]
        public void Load_RightHash_FindsFault(TableFault fault, int page, Damage damage)
        {
            fixed (byte* bytes = m_bytes)
                damage(new PlantedPage(bytes + m_pages[page].Link.OffsetBytes));
            Repair(page);
            Assert.That(FaultOf(page), Is.EqualTo(fault));
            Assert.That(LoadAll, Throws.TypeOf<PointCloudException>().With.Message.Contains(
                "hierarchy.bin: at byte " + m_pages[page].Link.OffsetBytes + ": ").And.Message.Not.Contains("\n"));
        }

        [Test]
        public void Load_WrongHash_SaysSo()
        {
            m_bytes[m_pages[1].Link.OffsetBytes + 100] ^= 1;
            Assert.That(FaultOf(1), Is.EqualTo(TableFault.Hash));
            Assert.That(LoadAll, Throws.TypeOf<PointCloudException>().With.Message.Contains("hash"));
        }

        [Test]
        public void Faults_OfAllKinds_AreTested()
        {
            var tested = Faults().Select(f => (TableFault)f.Arguments[0]).Append(TableFault.None).Append(TableFault.Hash);
            Assert.That(Enum.GetValues(typeof(TableFault)), Is.SubsetOf(tested));
        }

        [Test]
        public void Load_ManyMutationsWithRightHashes_GivesNodesOrOneLine()
        {
            var random = new Unity.Mathematics.Random(3);
            byte[] whole = (byte[])m_bytes.Clone();
            int opened = 0;
            for (int i = 0; i < Mutations; i++)
            {
                Array.Copy(whole, m_bytes, whole.Length);
                int page = random.NextInt(m_pages.Count);
                for (int n = random.NextInt(1, 4); n > 0; n--)
                    Mutate(ref random, page);
                Repair(page);
                try
                {
                    LoadAll();
                    opened++;
                }
                catch (PointCloudException e)
                {
                    Assert.That(e.Message, Does.StartWith(Folder.Path).And.Not.Contains("\n"), "mutation " + i);
                }
            }
            // Hashes of planes and bounds tell of no damage here.
            Assert.That(opened, Is.InRange(Mutations / 20, Mutations * 3 / 4));
        }

        [TestCase("rootBytes", "1", "rootOffset"), TestCase("rootBytes", "67108864", "rootOffset")]
        [TestCase("rootOffset", "96", "rootOffset"), TestCase("rootOffset", "9223372036854775807", "rootOffset")]
        [TestCase("bytes", "1", "rootOffset"), TestCase("bytes", "9223372036854775807", "rootOffset")]
        [TestCase("nodes", "1000", "nodes"), TestCase("nodes", "9223372036854775807", "nodes")]
        [TestCase("points", "9223372036854775807", "wanted 9223372036854775807 points")]
        public void Open_ManifestThatClaimsOtherSizes_IsRefused(string name, string value, string named)
        {
            string json = System.Text.RegularExpressions.Regex.Replace(m_manifest.ToJson(), "\"" + name + "\": \\d+",
                "\"" + name + "\": " + value);
            Assert.That(json, Is.Not.EqualTo(m_manifest.ToJson()));
            string path = Folder.Write(StoreFormat.ManifestName, json);
            Assert.That(() => CloudFolder.Open(Folder.Path), Throws.TypeOf<PointCloudException>().With.Message.Contains(named)
                .And.Message.StartsWith(named.StartsWith("wanted") ? HierarchyPath : path));
        }

        [Test]
        public void BitsOf_PageWithTheHashOfAnother_RemembersNothing()
        {
            Folder.Write(StoreFormat.ManifestName, m_manifest.ToJson());
            using var folder = CloudFolder.Open(Folder.Path);
            var bits = folder.VerifiedPlanes.BitsOf(m_pages[0].Link, "", 100);
            Assert.That(folder.VerifiedPlanes.BitsOf(m_pages[0].Link, "", 100), Is.SameAs(bits));
            Assert.That(folder.VerifiedPlanes.BitsOf(m_pages[0].Link, "", 1000), Is.Null);
        }

        void Mutate(ref Unity.Mathematics.Random random, int page)
        {
            var link = m_pages[page].Link;
            var at = new Span<byte>(m_bytes, (int)link.OffsetBytes + random.NextInt(link.LengthBytes / 4) * 4, 4);
            int value = BitConverter.ToInt32(at);
            BitConverter.TryWriteBytes(at, random.NextInt(5) switch
            {
                0 => value ^ 1 << random.NextInt(32),
                1 => value + random.NextInt(-2, 3),
                2 => random.NextInt(int.MinValue, int.MaxValue),
                3 => int.MaxValue - random.NextInt(2),
                _ => -random.NextInt(3),
            });
        }

        // Hashes of the page and of those above it.
        void Repair(int page)
        {
            fixed (byte* bytes = m_bytes)
            {
                for (; ; page = m_pages[page].Above)
                {
                    var known = m_pages[page];
                    known.Link.Hash = ContentHash.Of(bytes + known.Link.OffsetBytes, known.Link.LengthBytes);
                    m_pages[page] = known;
                    if (page == 0)
                        break;
                    ((PageLink*)(bytes + known.LinkAt))->Hash = known.Link.Hash;
                }
            }
            m_manifest.RootHash = m_pages[0].Link.Hash;
        }

        TableFault FaultOf(int page)
        {
            var link = m_pages[page].Link;
            using var bytes = new NativeArray<byte>(m_bytes.Skip((int)link.OffsetBytes).Take(link.LengthBytes).ToArray(),
                Allocator.Temp);
            using var shapes = m_manifest.CreateLayout().CreateShapes(Allocator.Temp);
            var first = (PlaneShape*)shapes.GetUnsafeReadOnlyPtr();
            return new TableCheck(bytes, link, m_manifest.LocalSpace, first, PlaneCount).FindProblem().Fault;
        }

        // As a stream does: builds what it streams of each page, too.
        void LoadAll()
        {
            File.WriteAllBytes(HierarchyPath, m_bytes);
            using var folder = CloudFolder.Open(Folder.Path, CloudManifest.FromJson(m_manifest.ToJson(), "cloud.json"));
            using var planes = new NativeArray<int>(new[] { 0, 1 }, Allocator.Temp);
            long pages = 0;
            foreach (var table in folder.EachTable())
            {
                Assert.That(++pages, Is.LessThanOrEqualTo(folder.Manifest.NodeCount));
                var built = new HierarchyPage();
                HierarchyPageBuilding.Build(table.View, planes, folder.Grid, ref built);
                built.Free();
            }
            foreach (var (path, _) in folder.Files())
                Assert.That(path, Does.StartWith(Folder.Path));
        }
    }
}
