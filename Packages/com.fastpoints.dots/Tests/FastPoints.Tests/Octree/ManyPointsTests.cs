using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using FastPoints.Base;
using FastPoints.Files;
using FastPoints.Octree;
using FastPoints.Pipeline;
using FastPoints.Points;
using NUnit.Framework;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Tests.Octree
{
    /// <summary>Counting and partition beyond 2^32 points, which nobody has the disk for in a test.</summary>
    public class ManyPointsTests
    {
        const long Points = 5L << 32;

        /// <summary>A source of twenty thousand million points: a grid of the plane, in blocks that are made when they are
        /// read.</summary>
        sealed class VirtualReader : PointReader
        {
            const int BlockPoints = 1 << 20;

            readonly long m_points;

            public VirtualReader(long points = ManyPointsTests.Points)
            {
                m_points = points;
                Info = new SourceInfo
                {
                    Path = "virtual",
                    Format = "virtual",
                    PointsClaimed = (ulong)points,
                    PointsReadable = points,
                    RecordBytes = 12,
                    Transform = new PositionTransform { Scale = new double3(0.01, 0.01, 0.01) },
                    Schema = new PointSchema(new[]
                    {
                        new PointAttribute(AttributeNames.X, AttributeType.Int32),
                        new PointAttribute(AttributeNames.Y, AttributeType.Int32),
                        new PointAttribute(AttributeNames.Z, AttributeType.Int32),
                    }),
                };
            }

            public override int BlockCount => (int)(m_points / BlockPoints);
            public override int MaxPointsPerBlock => BlockPoints;
            public override bool HasFixedStride => true;
            public override long FirstPointOfBlock(int block) => (long)block * BlockPoints;
            public override int PointsInBlock(int block) => BlockPoints;
            public override long BytesOfRange(BlockRange range) => 12L * range.Count;

            public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator) =>
                new Slot(this, wanted, capacity, allocator);

            public override void Dispose()
            {
            }
        }

        sealed class Slot : BlockRead
        {
            readonly PointReader m_reader;
            NativeReference<DecodeResult> m_result;

            public Slot(PointReader reader, PointSchema wanted, int capacity, Allocator allocator)
            {
                m_reader = reader;
                Points = new PointBatch(wanted, capacity, allocator);
                Result = m_result = new NativeReference<DecodeResult>(allocator);
            }

            public override void Begin(BlockRange range)
            {
                Range = range;
                FirstPoint = m_reader.FirstPointOfBlock(range.Block) + range.First;
                var bytes = Points.Bytes;
                for (int axis = 0; axis < 3; axis++)
                {
                    var column = bytes.GetSubArray(Points.Column(axis).OffsetBytes, 4 * range.Count).Reinterpret<int>(1);
                    for (int i = 0; i < range.Count; i++)
                    {
                        long point = FirstPoint + i;
                        column[i] = axis == 0 ? (int)(point % 150000) : axis == 1 ? (int)(point / 150000) : 7;
                    }
                }
                m_result.Value = new DecodeResult { Points = range.Count };
                Decoded = default;
            }

            public override void Complete() => Points.Count = m_result.Value.Points;

            public override void Dispose()
            {
                if (!m_result.IsCreated)
                    return;
                Points.Dispose();
                m_result.Dispose();
            }
        }

        [Test]
        public unsafe void Partition_OfMoreThanFourThousandMillionPoints_CountsThemAll()
        {
            using (var reader = new VirtualReader())
            {
                Assert.That(reader.PointCount, Is.EqualTo(Points));
                SourceSample sample = null;
                WorkPump.RunToEnd(SourceSample.Read(reader, 4, s => sample = s));
                using (sample)
                {
                    double weight = sample.Runs[0].Weight;
                    Assert.That(weight * sample.Stored.Length, Is.EqualTo((double)Points).Within(1e-6 * Points));
                    var cube = RootCube.Around(default, new Grid3(150000, Points / 150000, 7));
                    var axes = GridChoice.OnGrid(reader.Info, new CloudGrid { Step = new double3(0.01, 0.01, 0.01) });
                    var grid = new GridChoice { Sources = new[] { axes } };
                    var plan = MemoryPlan.For(reader.PointCount, 12, new ConvertSettings());
                    Assert.That(plan.IsStored, Is.True);
                    PartitionMap map = null;
                    WorkPump.RunToEnd(PartitionPlan.Of(cube, new List<SourceSample> { sample }, grid, Points, plan, m => map = m));
                    using (map)
                    {
                        var points = new double[map.Chunks.Length + 1];
                        int* chunkOfCell = (int*)map.ChunkOfCell.GetUnsafeReadOnlyPtr();
                        foreach (var stored in sample.Stored)
                            points[map.Finder.ChunkOf(chunkOfCell, SourceGrid.ToGrid(axes.X, stored.x),
                                SourceGrid.ToGrid(axes.Y, stored.y), SourceGrid.ToGrid(axes.Z, stored.z))] += weight;
                        Assert.That(points.Sum(), Is.EqualTo((double)Points).Within(1e-3 * Points));
                        Assert.That(points[map.Outside], Is.Zero);
                        // A run of the sample is in one cell and stands for 20 million points: no estimate is finer.
                        Assert.That(points.Max(), Is.LessThan(4.0 * plan.PointsPerPartition));
                        // Each has a page, and there is room for more.
                        Assert.That(points.Count(p => p > 0), Is.InRange(Points / plan.PointsPerPartition, plan.MostPages));
                    }
                }
            }
        }

        [Test]
        public void Groups_OfMoreThanFourThousandMillionPoints_AddUpInLongs()
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
        public void Journal_OfMoreThanFourThousandMillionPoints_ReadsBackTheSame()
        {
            var journal = new BuildJournal
            {
                Identity = ulong.MaxValue - 3,
                At = BuildJournal.Stage.Split,
                Block = 77,
                PeakBytes = Points
            };
            journal.Findings.Add(new PointFindings { Count = Points, Checksum = 1UL << 63, Max = new Grid3(1L << 59, 5, -1) });
            journal.Attributes = new[] { AttributeFindings.None };
            journal.Records.Add(Points);
            journal.Chunks.Add(new BuildJournal.Chunk
            {
                Cube = new GridCube(new Grid3(-1L << 59, 0, 0), 40),
                Runs = new[] { new RecordRun { File = 0, First = 1L << 33, Count = 1L << 34 } },
            });
            string text = journal.ToJson();
            var back = BuildJournal.FromJson(text);
            Assert.That(back.ToJson(), Is.EqualTo(text));
            Assert.That(back.Findings[0].Count, Is.EqualTo(Points));
            Assert.That(back.Chunks[0].Runs[0].Count, Is.EqualTo(1L << 34));
            Assert.That(BuildJournal.FromJson(text.Substring(0, text.Length / 2)), Is.Null);
            Assert.That(BuildJournal.FromJson("{}"), Is.Null);
        }

        [Test]
        public void Convert_MorePointsThanTheDiskHasRoomFor_SaysSoBeforeItReadsThem()
        {
            // 200 TB of records.
            string folder = Path.Combine(Path.GetTempPath(), "fastpoints-" + Guid.NewGuid().ToString("N"));
            Directory.CreateDirectory(folder);
            try
            {
                using (var reader = new VirtualReader(1L << 44))
                {
                    var work = ConvertCloud.Run(new[] { reader }, Path.Combine(folder, "cloud.fastpoints"), new ConvertSettings(),
                        r => { }, null);
                    var failure = Assert.Throws<PointCloudException>(() => WorkPump.RunToEnd(work));
                    Assert.That(failure.Code, Is.EqualTo(FailureCode.DiskFull));
                    Assert.That(failure.Message, Does.Contain("too little room"));
                }
                Assert.That(Directory.GetFileSystemEntries(folder), Is.Empty);
            }
            finally
            {
                Directory.Delete(folder, true);
            }
        }
    }
}
