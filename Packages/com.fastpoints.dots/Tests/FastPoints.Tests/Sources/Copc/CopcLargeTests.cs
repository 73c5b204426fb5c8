using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using FastPoints.Reading;
using FastPoints.Sources;
using FastPoints.Tests.Reading;
using NUnit.Framework;

namespace FastPoints.Tests.Sources
{
    public class CopcLargeTests
    {
        const string KeepVariable = "FASTPOINTS_COPC";

        [Test, Category("Long"), Explicit]
        public void Read_FiveMillionPoints_RoundTrips()
        {
            var writer = new CopcFileWriter { PointFormat = 7, MaxNodePoints = 50000, LevelsPerPage = 4 };
            long[] wanted;
            byte[] bytes;
            using (var reader = PointReaders.Open(TestData.PathOrIgnore("data/ca13_d.laz")))
            {
                writer.Scale = reader.Info.Transform.Scale;
                var records = Records(reader);
                wanted = Sums(records);
                bytes = writer.Write(records);
            }
            string kept = Environment.GetEnvironmentVariable(KeepVariable);
            if (!string.IsNullOrEmpty(kept))
                File.WriteAllBytes(kept, bytes);
            using (var file = new TemporaryFile(bytes, ".copc.laz"))
            using (var reader = PointReaders.Open(file.Path))
            {
                var watch = Stopwatch.StartNew();
                JobCoroutine.RunToEnd(reader.IndexBlocks());
                var sums = new long[4];
                var schema = reader.Info.Schema.Select(AttributeNames.X, AttributeNames.Y, AttributeNames.Z, AttributeNames.Red);
                long points = ReadPoints.EachBlock(reader, schema, read =>
                {
                    for (int axis = 0; axis < 3; axis++)
                        foreach (int value in read.Points.Column<int>(axis).GetSubArray(0, read.Points.Count))
                            sums[axis] += value;
                    foreach (ushort value in read.Points.Column<ushort>(3).GetSubArray(0, read.Points.Count))
                        sums[3] += value;
                });
                TestContext.WriteLine(points + " points of " + reader.Tree.NodeCount + " nodes in " + watch.ElapsedMilliseconds
                    + " ms");
                Assert.That(points, Is.EqualTo(5020835));
                Assert.That(sums, Is.EqualTo(wanted));
                Assert.That(reader.Tree.PageCount, Is.GreaterThan(1));
                Assert.That(reader.Info.Warnings, Is.Empty);
            }
        }

        /// <summary>Point format 7 from position, intensity and colour.</summary>
        static List<byte[]> Records(PointReader reader)
        {
            var records = new List<byte[]>();
            var schema = reader.Info.Schema.Select(AttributeNames.X, AttributeNames.Y, AttributeNames.Z, AttributeNames.Intensity,
                AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue);
            var at = new[] { 0, 4, 8, 12, 30, 32, 34 };
            ReadPoints.EachBlock(reader, schema, read =>
            {
                for (int i = 0; i < read.Points.Count; i++)
                {
                    var record = new byte[36];
                    for (int k = 0; k < at.Length; k++)
                    {
                        int value = k < 3 ? read.Points.Column<int>(k)[i] : read.Points.Column<ushort>(k)[i];
                        for (int b = 0; b < (k < 3 ? 4 : 2); b++)
                            record[at[k] + b] = (byte)(value >> 8 * b);
                    }
                    record[14] = 0x11;
                    records.Add(record);
                }
            });
            return records;
        }

        static long[] Sums(List<byte[]> records)
        {
            var sums = new long[4];
            foreach (var record in records)
            {
                for (int axis = 0; axis < 3; axis++)
                    sums[axis] += RecordFields.Int32(record, 4 * axis);
                sums[3] += RecordFields.UInt16(record, 30);
            }
            return sums;
        }
    }
}
