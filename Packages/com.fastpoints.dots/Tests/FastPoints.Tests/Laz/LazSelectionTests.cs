using System;
using System.Collections.Generic;
using System.Linq;
using FastPoints.Las;
using FastPoints.Laz;
using FastPoints.Reading;
using NUnit.Framework;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Tests.Laz
{
    public unsafe class LazSelectionTests
    {
        const int RecordBytes = 36, ColorLayer = 9;

        [Test]
        public void PlanLazReads_SomeLayers_ReadsOnlyThese()
        {
            // Sizes of the layers of point format 7; wanted: returns and XY, Z, then flags, then colour.
            var sizes = new uint[] { 1000, 500, 70, 60, 400, 30, 20, 10, 900, 800 };
            var wanted = new[] { 0, 1, 3, 9 };
            var commands = Plan(sizes, wanted, 1000000, 1 << 20, 1 << 20, out long inputBytes);
            int header = LazLayer.ChunkHeaderBytes(RecordBytes, 10);
            Assert.That(commands, Is.EqualTo(new[]
            {
                (5000L + header, 1500L), (5000L + header + 1570, 60L), (5000L + header + 2990, 800L),
            }));
            Assert.That(inputBytes, Is.EqualTo(header + 1500 + 60 + 800));
        }

        [Test]
        public void PlanLazReads_FewPoints_ReadsTheStartOfEachLayer()
        {
            var sizes = new uint[] { 100000, 50000, 70, 60, 400, 30, 20, 10, 900, 80000 };
            var commands = Plan(sizes, new[] { 0, 1 }, 10, 1 << 20, 1 << 20, out long inputBytes);
            Assert.That(commands.Length, Is.EqualTo(2));
            Assert.That(commands[0].Bytes, Is.EqualTo(4 + 24 * 10));
            Assert.That(commands[1].Bytes, Is.EqualTo(4 + 8 * 10));
            Assert.That(commands[1].Offset, Is.EqualTo(commands[0].Offset + 100000));
        }

        [Test]
        public void PlanLazReads_WrongSizes_StayInsideTheChunkAndTheBuffer()
        {
            var random = new Random(5);
            for (int i = 0; i < 500; i++)
            {
                var sizes = Enumerable.Range(0, 10).Select(_ => random.Next(3) == 0 ? uint.MaxValue - (uint)random.Next(9)
                    : (uint)random.Next(2000)).ToArray();
                var wanted = Enumerable.Range(0, 10).Where(_ => random.Next(2) == 0).Union(new[] { 0 }).OrderBy(k => k).ToArray();
                long chunk = random.Next(20, 9000);
                int buffer = random.Next(600, 5000);
                var commands = Plan(sizes, wanted, random.Next(1, 100000), chunk, buffer, out long inputBytes);
                Assert.That(inputBytes, Is.LessThanOrEqualTo(buffer));
                foreach (var command in commands)
                {
                    Assert.That(command.Offset, Is.GreaterThanOrEqualTo(5000));
                    Assert.That(command.Offset + command.Bytes, Is.LessThanOrEqualTo(5000 + chunk));
                    Assert.That(command.Bytes, Is.GreaterThan(0));
                }
            }
        }

        static (long Offset, long Bytes)[] Plan(uint[] sizes, int[] wanted, int points, long chunkBytes, int bufferBytes,
            out long inputBytes)
        {
            var perPoint = new[] { 24, 8, 2, 2, 5, 5, 2, 5, 24, 14 };
            using var input = new NativeArray<byte>(RecordBytes + 4 + 40, Allocator.TempJob);
            using var bytesPerPoint = new NativeArray<int>(10, Allocator.TempJob);
            using var commands = new NativeArray<ReadCommand>(10, Allocator.TempJob);
            using var array = new NativeArray<ReadCommandArray>(1, Allocator.TempJob);
            using var bytes = new NativeArray<long>(1, Allocator.TempJob);
            for (int i = 0; i < sizes.Length; i++)
                *(uint*)((byte*)input.GetUnsafePtr() + RecordBytes + 4 + 4 * i) = sizes[i];
            var asked = bytesPerPoint;
            foreach (int layer in wanted)
                asked[layer] = perPoint[layer];
            new PlanLazReadsJob
            {
                Input = input,
                BytesPerPoint = bytesPerPoint,
                Commands = commands,
                CommandArray = array,
                InputBytes = bytes,
                Buffer = null,
                BufferBytes = bufferBytes,
                RecordBytes = RecordBytes,
                ChunkOffset = 5000,
                ChunkEnd = 5000 + chunkBytes,
                Points = points,
            }.Run();
            inputBytes = bytes[0];
            return commands.Take(array[0].CommandCount).Select(command => (command.Offset, command.Size)).ToArray();
        }

        [Test]
        public void Read_NoiseInUnrequestedLayers_RequestedOnesAreCorrect()
        {
            var records = LazRecords.Make(7, 0, 3000, 81);
            var writer = new LazFileWriter { PointFormat = 7, ItemVersion = 3, ChunkPoints = new[] { 3000 } };
            var bytes = writer.Write(records);
            NoiseOnLayers(bytes, 2, ColorLayer);
            CheckPositions(bytes, records);
        }

        [Test]
        public void Read_FileTruncatedInAnUnrequestedLayer_RequestedOnesAreComplete()
        {
            var records = LazRecords.Make(7, 0, 3000, 91);
            var writer = new LazFileWriter { PointFormat = 7, ItemVersion = 3, ChunkPoints = new[] { 3000 } };
            var bytes = writer.Write(records);
            var layers = Layers(bytes);
            Array.Resize(ref bytes, (int)layers[ColorLayer].Offset + 10);
            CheckPositions(bytes, records);
        }

        static void CheckPositions(byte[] bytes, List<byte[]> records)
        {
            using var file = new TemporaryFile(bytes, ".laz");
            using var reader = LazFileReading.Open(file.Path);
            using var read = reader.CreateRead(reader.Info.Schema.Select(AttributeNames.X, AttributeNames.Y, AttributeNames.Z),
                records.Count, Allocator.Persistent);
            read.Begin(new BlockRange(0, 0, records.Count));
            read.Complete();
            Assert.That(read.Points.Count, Is.EqualTo(records.Count));
            var x = read.Points.Column<int>(AttributeNames.X);
            var z = read.Points.Column<int>(AttributeNames.Z);
            for (int i = 0; i < records.Count; i++)
            {
                Assert.That(x[i], Is.EqualTo(BitConverter.ToInt32(records[i], 0)));
                Assert.That(z[i], Is.EqualTo(BitConverter.ToInt32(records[i], 8)));
            }
        }

        static void NoiseOnLayers(byte[] file, int first, int last)
        {
            var random = new Random(1);
            var layers = Layers(file);
            for (int i = first; i <= last; i++)
                for (long at = layers[i].Offset; at < layers[i].Offset + layers[i].Bytes; at++)
                    file[at] = (byte)random.Next(256);
        }

        static (long Offset, long Bytes)[] Layers(byte[] file)
        {
            int chunk = BitConverter.ToInt32(file, LasHeader.At.PointsOffset) + LazChunkTable.TableOffsetSize;
            long at = chunk + LazLayer.ChunkHeaderBytes(RecordBytes, 10);
            var layers = new (long, long)[10];
            for (int i = 0; i < 10; i++)
            {
                long bytes = BitConverter.ToUInt32(file, chunk + RecordBytes + 4 + 4 * i);
                layers[i] = (at, bytes);
                at += bytes;
            }
            return layers;
        }
    }
}
