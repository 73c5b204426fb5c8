using System;
using System.Collections.Generic;
using System.Linq;
using FastPoints.Build;
using FastPoints.Store;
using NUnit.Framework;

namespace FastPoints.Tests.Store
{
    /// <summary>How nodes are cut into pages.</summary>
    public class HierarchyPagesTests : FolderTests
    {
        // All pages, which were checked, with the cubes of their nodes.
        readonly List<(PageLink Link, NodeRecord[] Nodes, PageLink[] Links, ContainerRecord Container)> m_pages =
            new List<(PageLink, NodeRecord[], PageLink[], ContainerRecord)>();

        int m_planeCount;
        readonly List<Subtree> m_parts = new List<Subtree>();

        [SetUp]
        public void Forget()
        {
            m_pages.Clear();
            m_parts.Clear();
        }

        Subtree Part(GridCube cube, params PlainNode[] roots)
        {
            var subtree = StoredHierarchy.Part(cube, m_planeCount, roots);
            m_parts.Add(subtree);
            return subtree;
        }

        void WriteAndRead(Subtree root)
        {
            var wanted = m_parts.SelectMany(p => CubesOf(p)).OrderBy(c => c).ToArray();
            var manifest = StoredHierarchy.Write(Folder.Path, root, m_planeCount);
            using var folder = CloudFolder.Open(Folder.Path, CloudManifest.FromJson(manifest.ToJson(), "cloud.json"));
            int page = 0;
            foreach (var table in folder.EachTable())
            {
                var container = table.Nodes.Length > 0 ? folder.PlanesContainerOf(page) : default;
                m_pages.Add((folder.LinkOf(page++), table.Nodes.ToArray(), table.Links.ToArray(), container));
            }
            var got = m_pages.SelectMany(p => p.Nodes.Select(n => NameOf(p.Container, n))).OrderBy(c => c);
            Assert.That(got, Is.EqualTo(wanted));
            Assert.That(m_pages.Sum(p => (long)p.Nodes.Length), Is.EqualTo(manifest.NodeCount));
            Assert.That(m_pages.Skip(1).Select(p => p.Link.OffsetBytes), Is.Unique.And.EquivalentTo(
                m_pages.SelectMany(p => p.Links).Select(l => l.OffsetBytes)));
            Assert.That(m_pages.Sum(p => (long)p.Link.LengthBytes),
                Is.EqualTo(manifest.HierarchyFileBytes - FileHeader.SizeBytes));
            foreach (var (link, nodes, _, _) in m_pages)
                Assert.That(link.LengthBytes <= StoreFormat.MaxPageBytes || IsOneNode(nodes), link.LengthBytes + " bytes, " +
                    nodes.Length + " nodes");
        }

        static bool IsOneNode(NodeRecord[] nodes) => nodes.Count(n => n.Parent < 0) == 1 &&
            nodes.Where(n => n.Parent >= 0).All(n => n.PlaneNode == 0);

        static IEnumerable<string> CubesOf(Subtree subtree) =>
            subtree.Table.GetSubArray(0, subtree.NodeCount * NodeRecord.SizeBytes)
            .Reinterpret<NodeRecord>(1).ToArray().Select(n => NameOf(subtree.Container, n));

        static string NameOf(in ContainerRecord container, in NodeRecord node) => container.Cube + " " + node.Cube + " " +
            node.PointCount;

        static void Grow(ref Unity.Mathematics.Random random, PlainNode node, int depth)
        {
            for (int octant = 0; octant < 8 && depth > 0; octant++)
            {
                bool isInlined = random.NextInt(3) == 0;
                var child = node.Add(node.Cube.Child(octant), isInlined);
                if (!isInlined)
                    Grow(ref random, child, depth - 1 - random.NextInt(2));
            }
        }

        // Every sub-cube of a third level.
        static void AddMany(PlainNode node, bool areInlined)
        {
            for (int i = 0; i < 512; i++)
                node.Add(node.Cube.Child(i & 7).Child(i >> 3 & 7).Child(i >> 6), areInlined);
        }

        static GridCube Descend(GridCube cube, int levels)
        {
            for (int i = 0; i < levels; i++)
                cube = cube.Child(i % 8);
            return cube;
        }

        [TestCase(1), TestCase(4), TestCase(60), TestCase(300), TestCase(4096)]
        public void Write_PartsOfAnyShape_HasEachNodeOnce(int planeCount)
        {
            m_planeCount = planeCount;
            var random = new Unity.Mathematics.Random((uint)planeCount);
            var root = new PlainNode(StoredHierarchy.Root);
            Grow(ref random, root, planeCount > 100 ? 2 : 4);
            foreach (var top in root.Children.Where(c => !c.IsInlined))
                foreach (int octant in new[] { 0, 3 })
                {
                    var cube = top.Cube.Child(octant);
                    var chunk = new PlainNode(cube);
                    Grow(ref random, chunk, planeCount > 100 ? 1 : 4);
                    if (chunk.Children.Count > 0)
                        top.Below.Add(Part(cube, chunk.Children.Where(c => !c.IsInlined).DefaultIfEmpty(chunk).ToArray()));
                }
            WriteAndRead(Part(StoredHierarchy.Root, root));
            Assert.That(m_pages.Count, Is.GreaterThan(planeCount == 1 ? 2 : 10));
        }

        [Test]
        public void Write_OneNodeOf512Children_CutsThemIntoPages([Values] bool areInlined, [Values(1, 12)] int planeCount)
        {
            m_planeCount = planeCount;
            var root = new PlainNode(StoredHierarchy.Root);
            AddMany(root, areInlined);
            for (int i = 0; i < 512 && !areInlined; i += 32)
                AddMany(root.Children[i], true);
            WriteAndRead(Part(StoredHierarchy.Root, root));
        }

        // A page that its nodes nearly fill, each of which has eight pages of children.
        [Test]
        public void Write_ManyNodesWithPagesOfChildren_HasRoomForTheirLinks()
        {
            m_planeCount = 300;
            var root = new PlainNode(StoredHierarchy.Root);
            for (int i = 0; i < 11; i++)
            {
                var child = root.Add(root.Cube.Child(i % 8).Child(i / 8));
                for (int o = 0; o < 8; o++)
                {
                    var below = child.Add(o);
                    for (int k = 0; k < 12; k++)
                        below.Add(below.Cube.Child(k % 8), true);
                }
            }
            WriteAndRead(Part(StoredHierarchy.Root, root));
        }

        [Test]
        public void Write_DeepChain_HasPagesBelowPages()
        {
            m_planeCount = 4;
            var root = new PlainNode(StoredHierarchy.Root);
            var at = root;
            while (at.Cube.SideLog2 > 0)
                at = at.Add(at.Cube.SideLog2 % 8);
            for (int i = 0; i < 3000; i++)
                at = at.Add(at.Cube);
            WriteAndRead(Part(StoredHierarchy.Root, root));
            Assert.That(m_pages.Count, Is.GreaterThan(5));
        }

        [Test]
        public void Write_ManyPartsOnOneNode_LinksThemAllAndKeepsThemTogether([Values(100, 2000)] int parts)
        {
            m_planeCount = 4;
            var root = new PlainNode(StoredHierarchy.Root);
            for (int i = 0; i < 8; i++)
                root.Add(i);
            var on = root.Children[5];
            for (int i = 0; i < parts; i++)
            {
                var chunk = new PlainNode(new GridCube(on.Cube.Corner + new Grid3(i * (1L << 20), 0, 0), 20));
                for (int octant = 0; octant < 8; octant++)
                    chunk.Add(octant).Add(octant);
                on.Below.Add(Part(chunk.Cube, chunk.Children.ToArray()));
            }
            WriteAndRead(Part(StoredHierarchy.Root, root));
            var links = m_pages.First(p => p.Links.Length >= parts).Links;
            for (int i = 1; i < parts; i++)
                Assert.That(links[i].OffsetBytes, Is.EqualTo(links[i - 1].OffsetBytes + links[i - 1].LengthBytes));
        }

        [Test]
        public void Write_CloudWithoutPoints_IsOneEmptyPage()
        {
            m_planeCount = 3;
            WriteAndRead(new Subtree());
            Assert.That(m_pages.Single().Nodes, Is.Empty);
        }
    }
}
