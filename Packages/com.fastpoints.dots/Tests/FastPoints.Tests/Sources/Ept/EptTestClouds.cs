using System;
using System.Collections.Generic;
using System.Linq;
using FastPoints.Reading;
using FastPoints.Sources;
using FastPoints.Tests.Reading;
using NUnit.Framework;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;
using Random = System.Random;

namespace FastPoints.Tests.Sources
{
    static class EptTestClouds
    {
        static readonly (string, string, int)[] s_dimensions =
        {
            ("Intensity", "unsigned", 2), ("ScanAngleRank", "float", 4), ("GpsTime", "float", 8), ("Red", "unsigned", 2),
            ("Green", "unsigned", 2), ("Blue", "unsigned", 2), ("Odd", "signed", 1), ("Big", "unsigned", 8), ("Low", "signed", 8),
        };

        public static EptFolder Make(EptDataType type, int points = 1500, int levelsPerPage = 99,
            int format = 3, int maxNodePoints = 100)
        {
            if (type == EptDataType.Laszip)
                return new EptFolder(type, LazRecords.Make(format, 4, points, 21),
                    new (string, string, int)[0], format, maxNodePoints, levelsPerPage);
            var random = new Random(points);
            var records = new List<byte[]>();
            for (int i = 0; i < points; i++)
            {
                var record = new byte[12 + s_dimensions.Sum(dimension => dimension.Item3)];
                random.NextBytes(record);
                for (int axis = 0; axis < 3; axis++)
                    BitConverter.GetBytes(random.Next(-100000, 100000) >> random.Next(8)).CopyTo(record, 4 * axis);
                records.Add(record);
            }
            return new EptFolder(type, records, s_dimensions, 0, maxNodePoints, levelsPerPage);
        }

        public static long Count(PointReader reader) => ReadPoints.EachBlock(reader, reader.Info.Schema, read => { });

        public static void CheckWarned(PointReader reader, string detail) =>
            Assert.That(reader.Info.Warnings.Select(warning => warning.Text), Has.Some.Contains(detail));

        public static unsafe void CheckNodes(PointReader reader, EptFolder folder, int slots, bool isReversed)
        {
            var nodes = folder.Nodes.ToDictionary(node => new int4(node.Cell, node.Level));
            Assert.That(reader.Tree.NodeCount, Is.EqualTo(nodes.Count));
            var order = Enumerable.Range(0, reader.Tree.NodeCount).Where(i => reader.Tree[i].Block >= 0).ToList();
            if (isReversed)
                order.Reverse();
            var reads = new BlockRead[slots];
            for (int i = 0; i < slots; i++)
                reads[i] = reader.CreateRead(reader.Info.Schema, reader.MaxPointsPerBlock, Allocator.Persistent);
            for (int i = 0; i < order.Count + slots; i++)
            {
                var read = reads[i % slots];
                if (i >= slots && i - slots < order.Count)
                {
                    var node = reader.Tree[order[i - slots]];
                    read.Complete();
                    var records = nodes[new int4(node.Cell, node.Level)].Records;
                    Assert.That(read.Points.Count, Is.EqualTo(records.Count));
                    var fields = new PointField[reader.Info.Schema.Count];
                    var columns = new PointColumn[fields.Length];
                    int at = 0;
                    for (int k = 0; k < fields.Length; k++)
                    {
                        var attribute = reader.Info.Schema[k];
                        if (folder.DataType != EptDataType.Laszip)
                            fields[k] = new PointField(attribute.Name, attribute.Type, at);
                        at += attribute.Type.SizeOf();
                        columns[k] = read.Points.Column(k);
                    }
                    var copies = folder.DataType == EptDataType.Laszip
                        ? FieldCopyPlan.Make(LazFileReading.LayoutOf(folder.DataPath(EptFolder.NameOf(folder.Nodes[0]))).Fields,
                            read.Points)
                        : FieldCopyPlan.Make(fields, columns);
                    var got = new byte[records.Count * folder.RecordBytes];
                    fixed (byte* first = got)
                    fixed (FieldCopy* plan = copies)
                        PointRecords.FromColumns((byte*)read.Points.Bytes.GetUnsafeReadOnlyPtr(), 0,
                            records.Count, new FieldCopies(plan, copies.Length), first, folder.RecordBytes);
                    Assert.That(LazFileReading.Difference(got, records.SelectMany(r => r).ToArray(), folder.RecordBytes),
                        Is.Null);
                }
                if (i < order.Count)
                {
                    int block = reader.Tree[order[i]].Block;
                    read.Begin(new BlockRange(block, 0, reader.PointsInBlock(block)));
                }
            }
            foreach (var read in reads)
                read.Dispose();
        }
    }
}
