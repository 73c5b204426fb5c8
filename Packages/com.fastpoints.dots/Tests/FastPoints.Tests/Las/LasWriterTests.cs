using System;
using System.IO;
using FastPoints.Las;
using FastPoints.Reading;
using FastPoints.Scenes;
using FastPoints.Sources;
using FastPoints.Tests.Reading;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Tests.Las
{
    public class LasWriterTests : FolderTests
    {
        string FilePath => Folder.File("cloud.las");

        [TearDown]
        public void NothingIsLeftBesideTheFile()
        {
            File.Delete(FilePath);
            Assert.That(Directory.GetFiles(Folder.Path), Is.Empty);
        }

        [Test]
        public void Append_ColumnsOfEachFormat_ReadBackTheSame([Range(0, 10)] int format)
        {
            var extra = new[]
            {
                new PointAttribute("Height", AttributeType.Float32), new PointAttribute("Grade", AttributeType.Int16, 0.5, -3),
            };
            var settings = new LasWriterSettings { PointFormat = format, ExtraBytes = extra, Wkt = "LOCAL_CS[\"here\"]" };
            using var source = new LasTestFile { Minor = 4, Format = format, ExtraBytes = 6 }.RandomPoints(3000).Save();
            using (var batch = Batch(settings, source, out var schema))
            using (var writer = LasWriter.Create(FilePath, settings))
            {
                Assert.That(writer.Schema, Is.EqualTo(schema));
                writer.Append(batch);
                writer.AppendRecords(source.Points, 2);
                writer.Complete();
            }
            using var reader = (LasReader)PointReaders.Open(FilePath);
            Assert.That(reader.Info.Warnings, Is.Empty);
            Assert.That(reader.PointCount, Is.EqualTo(3002));
            Assert.That(reader.Info.Crs.Name, Is.EqualTo("here"));
            var records = File.ReadAllBytes(FilePath).AsSpan((int)reader.Header.PointsOffset, 3000 * source.RecordBytes);
            Assert.That(records.SequenceEqual(source.Points));
        }

        [Test]
        public void Complete_Header_HasCountsReturnsAndBounds([Values(1, 7)] int format)
        {
            var settings = new LasWriterSettings
            {
                PointFormat = format,
                Scale = new double3(0.5, -0.25, 0.001),
                Offset = new double3(10, 20, 30),
            };
            var schema = new PointSchema(new[]
            {
                new PointAttribute(AttributeNames.X, AttributeType.Int32),
                new PointAttribute(AttributeNames.Y, AttributeType.Int32),
                new PointAttribute(AttributeNames.Z, AttributeType.Int32),
                new PointAttribute(AttributeNames.ReturnNumber, AttributeType.UInt8),
            });
            using (var batch = new PointBatch(schema, 3, Allocator.Persistent))
            using (var writer = LasWriter.Create(FilePath, settings))
            {
                for (int axis = 0; axis < 3; axis++)
                {
                    var column = batch.Column<int>(axis);
                    column[0] = 4 + axis;
                    column[1] = -4;
                    column[2] = 0;
                }
                var returns = batch.Column<byte>(3);
                returns[0] = 1;
                returns[1] = 5;
                returns[2] = 1;
                batch.Count = 3;
                writer.Append(batch);
                writer.Append(batch);
                writer.Complete();
                writer.Dispose();
                Assert.That(() => writer.AppendRecords(new byte[100], 1), Throws.InvalidOperationException);
            }
            using var reader = (LasReader)PointReaders.Open(FilePath);
            Assert.That(reader.Header.PointsClaimed, Is.EqualTo(6));
            Assert.That(reader.Header.LegacyCount, Is.EqualTo(format == 1 ? 6 : 0));
            Assert.That(reader.Header.ByReturn[0], Is.EqualTo(4));
            Assert.That(reader.Header.ByReturn[4], Is.EqualTo(2));
            Assert.That(reader.Header.LegacyByReturn[4], Is.EqualTo(format == 1 ? 2 : 0));
            Assert.That(reader.Header.Min, Is.EqualTo(new double3(8, 18.75, 29.996)));
            Assert.That(reader.Header.Max, Is.EqualTo(new double3(12, 21, 30.006)));
            Assert.That(reader.Info.Warnings, Is.Empty);
        }

        [Test]
        public void Dispose_BeforeComplete_LeavesNothingAndTheOldFile()
        {
            File.WriteAllText(FilePath, "old");
            using (var writer = LasWriter.Create(FilePath, new LasWriterSettings()))
                writer.AppendRecords(new byte[36 * 10], 10);
            Assert.That(File.ReadAllText(FilePath), Is.EqualTo("old"));
            Assert.That(Directory.GetFiles(Folder.Path).Length, Is.EqualTo(1));

            using (var writer = LasWriter.Create(FilePath, new LasWriterSettings()))
                writer.Complete();
            using var reader = PointReaders.Open(FilePath);
            Assert.That(reader.PointCount, Is.Zero);
        }

        static PointBatch Batch(LasWriterSettings settings, LasTestFile file, out PointSchema schema)
        {
            var attributes = new System.Collections.Generic.List<PointAttribute>();
            foreach (var field in LasPointFormat.Of(settings.PointFormat).Fields)
                attributes.Add(field.ToAttribute());
            attributes.AddRange(settings.ExtraBytes);
            schema = new PointSchema(attributes);
            var batch = new PointBatch(schema, file.Count, Allocator.Persistent);
            using (var reader = PointReaders.Open(file.Path))
            {
                ReadPoints.EachBlock(reader, LasPointFormatSchema(reader, settings.PointFormat), read =>
                {
                    for (int column = 0; column < read.Points.Schema.Count; column++)
                    {
                        int bytes = file.Count * read.Points.Schema[column].Type.SizeOf();
                        NativeArray<byte>.Copy(read.Points.Bytes, read.Points.Column(column).OffsetBytes, batch.Bytes,
                            batch.Column(column).OffsetBytes, bytes);
                    }
                });
            }
            // The extra bytes have no description in the source: taken from the records themselves.
            var heights = batch.Column<float>("Height");
            var grades = batch.Column<short>("Grade");
            for (int i = 0; i < file.Count; i++)
            {
                int extra = (i + 1) * file.RecordBytes - 6;
                heights[i] = BitConverter.ToSingle(file.Points, extra);
                grades[i] = BitConverter.ToInt16(file.Points, extra + 4);
            }
            batch.Count = file.Count;
            return batch;
        }

        static PointSchema LasPointFormatSchema(PointReader reader, int format)
        {
            var names = new string[LasPointFormat.Of(format).Fields.Count];
            for (int i = 0; i < names.Length; i++)
                names[i] = LasPointFormat.Of(format).Fields[i].Name;
            return reader.Info.Schema.Select(names);
        }
    }
}
