using System.Collections.Generic;
using System.IO;
using System.Linq;
using FastPoints.Build;
using FastPoints.Picture;
using FastPoints.Store;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Store
{
    /// <summary>What an overview of 10^12 points reads of the hierarchy: a plane of chunks, their upper nodes sampled together by
    /// sixteen, as in a country. A chunk is simulated by one node with all its points: no overview comes to it.</summary>
    public unsafe class LargeHierarchyTests : FolderTests
    {
        const int PlaneCount = 3;
        const long Points = 1_000_000_000_000;
        const int MaxGapBytes = 64 << 10;
        const int WidthPx = 1920;
        const int HeightPx = 1080;

        int m_chunkLevel;

        // Of a cube with nodes of two levels, and regions or chunks on those of the second.
        Subtree Region(GridCube cube, int level)
        {
            var roots = new List<PlainNode>();
            if (level == 0)
                roots.Add(new PlainNode(cube));
            for (int i = 0; i < 4; i++)
                roots.Add(level == 0 ? roots[0].Add(i) : new PlainNode(cube.Child(i)));
            var lowest = level == 0 ? roots[0].Children : roots.SelectMany(r => Enumerable.Range(0, 4).Select(r.Add)).ToList();
            foreach (var node in lowest.Concat(roots))
                node.PointCount = 45_000;
            int next = level == 0 ? 1 : level + 2;
            foreach (var node in lowest)
                node.Below.Add(next < m_chunkLevel ? Region(node.Cube, next) : Chunk(node.Cube));
            return StoredHierarchy.Part(cube, PlaneCount, level == 0 ? roots.Take(1).ToArray() : roots.ToArray());
        }

        Subtree Chunk(GridCube cube) => StoredHierarchy.Part(cube, PlaneCount, new PlainNode(cube.Child(0))
        {
            PointCount = (int)(Points >> (2 * m_chunkLevel)),
        });

        [TestCase(7)]
        public void Select_OverviewOfATrillionPoints_ReadsFewPages(int chunkLevel)
        {
            m_chunkLevel = chunkLevel;
            var manifest = StoredHierarchy.Write(Folder.Path, Region(StoredHierarchy.Root, 0), PlaneCount);
            string json = Folder.Write(StoreFormat.ManifestName, manifest.ToJson());
            Assert.That(manifest.Points, Is.GreaterThanOrEqualTo(Points - (1 << 20)));
            using var folder = CloudFolder.Open(Folder.Path);
            using var selection = new NodeSelection(folder);
            double side = manifest.Root.Side * manifest.Grid.Step.x;
            var center = new double3(0.5, 0.5, 0) * side;
            var camera = Camera.Perspective(center + new double3(0, -0.3, 1) * side, center, new double3(0, 1, 0), 60);
            selection.Choose(camera.ToStreamView(WidthPx, HeightPx), 3_000_000);

            // By how many pages are above them.
            var pages = new List<List<PageLink>>();
            AddRead(folder, 0, 0, pages);
            long bytes = new FileInfo(json).Length + pages.Sum(level => level.Sum(p => (long)p.LengthBytes));
            var requests = pages.Select(RequestsFor).ToArray();

            TestContext.WriteLine(manifest.Points + " points, " + (1 << 2 * chunkLevel) + " chunks, " + manifest.NodeCount +
                " nodes; file " + manifest.HierarchyFileBytes + " bytes, cloud.json " + new FileInfo(json).Length + "; chosen " +
                selection.NodeCount + " nodes, " + selection.Points + " points; read " + bytes + " bytes: pages by depth " +
                string.Join(", ", pages.Select(p => p.Count)) + "; requests " + string.Join(", ", requests) + "; known pages " +
                folder.PageCount + " of " + sizeof(HierarchyPage) + " bytes for streaming");
            Assert.That(selection.Points, Is.GreaterThan(1_000_000));
            Assert.That(bytes, Is.LessThanOrEqualTo(1 << 20));
            // cloud.json, the root's page, and what the first selection misses.
            Assert.That(1 + requests[0] + requests[1], Is.LessThanOrEqualTo(3));
            Assert.That(folder.PageCount, Is.LessThan(2000));
        }

        static void AddRead(CloudFolder folder, int page, int depth, List<List<PageLink>> pages)
        {
            if (folder.FirstBelow(page) < 0)
                return;
            if (pages.Count == depth)
                pages.Add(new List<PageLink>());
            pages[depth].Add(folder.LinkOf(page));
            using var table = folder.LoadPage(page);
            for (int l = 0; l < table.Links.Length; l++)
                AddRead(folder, folder.FirstBelow(page) + l, depth + 1, pages);
        }

        static int RequestsFor(List<PageLink> pages)
        {
            long end = long.MinValue / 2;
            int requests = 0;
            foreach (var page in pages.OrderBy(p => p.OffsetBytes))
            {
                requests += page.OffsetBytes - end > MaxGapBytes ? 1 : 0;
                end = page.OffsetBytes + page.LengthBytes;
            }
            return requests;
        }
    }
}
