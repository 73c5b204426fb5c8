using System.Collections.Generic;
using System.IO;
using System.Linq;
using FastPoints.Build;
using FastPoints.Nodes;
using FastPoints.Sampling;
using NUnit.Framework;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Tests.Nodes
{
    /// <summary>Counting and partition beyond 2^32 points, too many for a disk in a test.</summary>
    public class ManyPointsTests
    {
        const long Points = 5L << 32;

        [Test]
        public unsafe void Partition_OfMoreThan2To32Points_CountsAll()
        {
            using var reader = new VirtualReader(Points);
            Assert.That(reader.PointCount, Is.EqualTo(Points));
            SourceSample sample = null;
            JobCoroutine.RunToEnd(SourceSample.Read(reader, () => 0, 0, 1 << 20, (_, loaded) => loaded, s => sample = s));
            using (sample)
            {
                double weight = sample.Ranges[0].Weight;
                Assert.That(weight * sample.Stored.Length, Is.EqualTo((double)Points).Within(1e-6 * Points));
                var cube = RootCube.Around(default, new Grid3(150000, Points / 150000, 7));
                var axes = GridChoice.OnGrid(reader.Info, new CloudGrid { Step = new double3(0.01, 0.01, 0.01) });
                var grid = new GridChoice { Sources = new[] { axes } };
                var plan = MemoryPlan.For(reader.PointCount, 12, new ConvertSettings());
                Assert.That(plan.UsesTemporaryFiles, Is.True);
                PartitionMap map = null;
                using (var slices = new SliceTimes(Allocator.Persistent))
                    JobCoroutine.RunToEnd(PartitionPlan.Of(cube, new List<SourceSample> { sample }, grid, plan, slices,
                        m => map = m));
                using (map)
                {
                    var points = new double[map.Chunks.Length + 1];
                    int* chunkOfCell = (int*)map.ChunkOfCell.GetUnsafeReadOnlyPtr();
                    foreach (var stored in sample.Stored)
                        points[map.Finder.ChunkOf(chunkOfCell, SourceToGrid.ToGrid(axes.X, stored.x),
                            SourceToGrid.ToGrid(axes.Y, stored.y), SourceToGrid.ToGrid(axes.Z, stored.z))] += weight;
                    Assert.That(points.Sum(), Is.EqualTo((double)Points).Within(1e-3 * Points));
                    Assert.That(points[map.OutsideChunk], Is.Zero);
                    // A range of the sample is in one cell and stands for 20 million points: no estimate is finer.
                    Assert.That(points.Max(), Is.LessThan(4.0 * plan.MaxPointsPerPlannedCube));
                    // Each has a page, and there is room for more.
                    Assert.That(points.Count(p => p > 0), Is.InRange(Points / plan.MaxPointsPerPlannedCube, plan.MaxPages));
                }
            }
        }

        [Test]
        public void Groups_OfMoreThan2To32Points_AreSummedInLongs()
        {
            var root = new GridCube(default, 20);
            var items = new List<GridCube>();
            for (int octant = 0; octant < 8; octant++)
                for (int child = 0; child < 8; child++)
                    items.Add(root.Child(octant).Child(child));
            var groups = CubeGroups.Of(root, items, c => c, c => 3L << 30, 26L << 30);
            Assert.That(groups, Has.Count.EqualTo(8));
            Assert.That(groups[5].Cube, Is.EqualTo(root.Child(5)));
            Assert.That(CubeGroups.Of(root, items, c => c, c => 3L << 30, 23L << 30), Has.Count.EqualTo(64));
        }

        [Test]
        public void Journal_OfMoreThan2To32Points_RoundTrips()
        {
            var journal = new BuildJournal
            {
                Identity = ulong.MaxValue - 3,
                CurrentStage = BuildJournal.Stage.Split,
                Block = 77,
                PeakBytes = Points
            };
            var max = new Grid3(1L << 59, 5, -1);
            journal.Statistics.Add(new PointStatistics { Count = Points, Checksum = 1UL << 63, Max = max });
            journal.Attributes = new[] { AttributeStatistics.None };
            journal.RecordCountOfFile.Add(Points);
            journal.Chunks.Add(new BuildJournal.Chunk
            {
                Cube = new GridCube(new Grid3(-1L << 59, 0, 0), 40),
                Ranges = new[] { new RecordRange { File = 0, First = 1L << 33, Count = 1L << 34 } },
            });
            string text = journal.ToJson();
            var back = BuildJournal.FromJson(text);
            Assert.That(back.ToJson(), Is.EqualTo(text));
            Assert.That(back.Statistics[0].Count, Is.EqualTo(Points));
            Assert.That(back.Chunks[0].Ranges[0].Count, Is.EqualTo(1L << 34));
            Assert.That(BuildJournal.FromJson(text.Substring(0, text.Length / 2)), Is.Null);
            Assert.That(BuildJournal.FromJson("{}"), Is.Null);
        }

        [Test]
        public void Convert_NotEnoughDiskSpace_FailsBeforeReading()
        {
            // 200 TB of records.
            using var folder = new TemporaryFolder();
            using (var reader = new VirtualReader(1L << 44))
            {
                var work = ConvertCloud.Run(new[] { reader }, folder.File("cloud.fastpoints"), new ConvertSettings(),
                    r => { }, null);
                Failures.Of(() => JobCoroutine.RunToEnd(work), FailureCode.DiskFull, "too little room");
            }
            FileChanges.AwaitDeletes();
            Assert.That(Directory.GetFileSystemEntries(folder.Path), Is.Empty);
        }
    }
}
