using System;
using System.Collections.Generic;
using System.Linq;
using FastPoints.Build;
using FastPoints.Export;
using FastPoints.Nodes;
using FastPoints.Reading;
using FastPoints.Store;
using FastPoints.Tests.Nodes;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Build
{
    /// <summary>Where the planes of nodes lie in a file.</summary>
    public class PlaneOrderTests : FolderTests
    {
        string Convert(Sampler sampler, bool hasColor)
        {
            var random = new Unity.Mathematics.Random(5);
            var positions = new int3[440000];
            for (int i = 0; i < positions.Length; i++)
                positions[i] = random.NextInt3(100000);
            var transform = new PositionTransform { Scale = new double3(0.01, 0.01, 0.01) };
            using PointReader reader = hasColor ? MemoryReader.Of(positions, transform)
                : new MemoryReader(new PointSchema(PositionColumns.Attributes(AttributeType.Int32).Append(
                    new PointAttribute(AttributeNames.Intensity, AttributeType.UInt16)).ToList()), transform, 1000,
                    positions.Select(p => p.x).ToArray(), positions.Select(p => p.y).ToArray(),
                    positions.Select(p => p.z).ToArray(), positions.Select(p => (ushort)p.x).ToArray());
            string path = Folder.File("cloud" + StoreFormat.FolderExtension);
            JobCoroutine.RunToEnd(ConvertCloud.Run(new[] { reader }, path,
                new ConvertSettings { PointsPerChunk = 100000, Sampler = sampler }, _ => { }, null));
            return path;
        }

        [Test]
        public void Convert_AnyFile_HasPositionsAndColorsOfAllNodesInFront([Values] Sampler sampler, [Values] bool hasColor)
        {
            using var folder = CloudFolder.Open(Convert(sampler, hasColor));
            int page = 0;
            foreach (var table in folder.EachTable())
                AssertOrder(table, folder.Layout, folder.PlanesContainerOf(page++).FileBytes);
            Assert.That(page, Is.GreaterThan(1));
        }

        // Breadth first, as the table is, one behind the other from the header to the end.
        static void AssertOrder(NodeTable table, StoreLayout layout, long dataBytes)
        {
            int color = layout.PlaneOf(StoreLayout.ColorName);
            long end = FileHeader.SizeBytes;
            foreach (bool isInFront in new[] { true, false })
            {
                for (int n = 0; n < table.Nodes.Length; n++)
                {
                    for (int p = 0; p < table.PlaneCount; p++)
                    {
                        var range = table.PlaneRanges[n * table.PlaneCount + p];
                        if (table.Nodes[n].PlaneNode != n || isInFront != (p == StoreLayout.PositionPlane || p == color))
                            continue;
                        int averaged = layout.Planes[p].AverageOf;
                        if (averaged >= 0 && range.Equals(table.PlaneRanges[n * table.PlaneCount + averaged]))
                            continue;
                        Assert.That(range.OffsetBytes, Is.EqualTo(end), "node " + n + ", plane " + layout.Planes[p].Name);
                        end += range.LengthBytes;
                    }
                }
            }
            Assert.That(end, Is.EqualTo(dataBytes));
        }

        [Test]
        public void ListPieces_OfAllNodes_NamesEachByteAboutOnce()
        {
            using var reader = ConvertedReader.Open(Convert(Sampler.Poisson, true));
            var pieces = new List<FilePiece>();
            for (int block = 0; block < reader.BlockCount; block++)
                reader.ListPieces(new BlockRange(block, 0, reader.PointsInBlock(block)), pieces);
            using var folder = CloudFolder.Open(reader.Info.Path);
            _ = folder.EachTable().Count();
            long stored = folder.Files().Sum(f => f.Bytes) - folder.Manifest.HierarchyFileBytes;
            Assert.That(pieces.Sum(p => p.LengthBytes), Is.InRange(stored * 9 / 10, stored * 11 / 10));
        }
    }
}
