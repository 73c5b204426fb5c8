using System;
using System.Collections.Generic;
using FastPoints.Reading;
using FastPoints.Sources;
using NUnit.Framework;
using Unity.Collections;

namespace FastPoints.Tests.Laz
{
    public class LazStateTests
    {
        static IEnumerable<int[]> FormatsAndSelections()
        {
            for (int format = 0; format <= 10; format++)
                for (int selection = 0; selection < 2; selection++)
                    yield return new[] { format, selection };
        }

        static PointSchema Wanted(PointReader reader, int selection) => selection == 0 ? reader.Info.Schema
            : reader.Info.Schema.Select(AttributeNames.X, AttributeNames.Y, AttributeNames.Z, AttributeNames.Red,
                AttributeNames.Green, AttributeNames.Blue);

        static TemporaryFile Save(int format, int points, int chunkPoints)
        {
            var writer = new LazFileWriter
            {
                PointFormat = format,
                ItemVersion = format < 6 ? 2 : 3,
                ChunkPoints = new[] { chunkPoints },
            };
            return new TemporaryFile(writer.Write(LazRecords.Make(format, 0, points, 31 + format)), ".laz");
        }

        [TestCaseSource(nameof(FormatsAndSelections))]
        public void Begin_FromSavedStates_GivesTheSameBytes(int[] formatAndSelection)
        {
            // Layers of chunks of 3,000 points are read on their own where not all are wanted.
            using var file = Save(formatAndSelection[0], 7000, 3000);
            using var reader = PointReaders.Open(file.Path);
            var schema = Wanted(reader, formatAndSelection[1]);
            using var whole = reader.CreateRead(schema, 3000, Allocator.Persistent);
            using var one = reader.CreateRead(schema, 3000, Allocator.Persistent);
            using var other = reader.CreateRead(schema, 3000, Allocator.Persistent);
            Assert.That(one.TryEnableStates() && other.TryEnableStates(), Is.True);
            var states = new DecoderState[reader.BlockCount];
            // Blocks in turn, the slots in turn: any slot goes on where another one was.
            int turn = 0;
            for (int first = 0; first < 3000; first += 700)
                for (int block = 0; block < reader.BlockCount; block++)
                {
                    int count = Math.Min(700, reader.PointsInBlock(block) - first);
                    if (count <= 0)
                        continue;
                    var read = turn++ % 2 == 0 ? one : other;
                    read.Begin(new BlockRange(block, first, count), states[block]);
                    read.Complete();
                    Assert.That(read.Points.Count, Is.EqualTo(count));
                    states[block] = read.KeepState(states[block]);
                    Assert.That(states[block].Bytes, Is.GreaterThan(0));
                    whole.Begin(new BlockRange(block, first, count));
                    whole.Complete();
                    for (int column = 0; column < schema.Count; column++)
                        Assert.That(Column(read.Points, column), Is.EqualTo(Column(whole.Points, column)));
                }
            foreach (var state in states)
                state.Dispose();
        }

        static byte[] Column(PointBatch points, int column)
        {
            var at = points.Column(column);
            return points.Bytes.GetSubArray((int)at.OffsetBytes, points.Count * at.Type.SizeOf()).ToArray();
        }

        [Test]
        public void KeepState_NotRequested_Throws()
        {
            using var file = Save(2, 100, 100);
            using var reader = PointReaders.Open(file.Path);
            using var read = reader.CreateRead(reader.Info.Schema, 100, Allocator.Persistent);
            read.Begin(new BlockRange(0, 0, 50));
            read.Complete();
            Assert.That(() => read.KeepState(null), Throws.InvalidOperationException);
        }

        [Test]
        public void Begin_StateAfterTheRange_Throws()
        {
            using var file = Save(2, 100, 100);
            using var reader = PointReaders.Open(file.Path);
            using var read = reader.CreateRead(reader.Info.Schema, 100, Allocator.Persistent);
            Assert.That(read.TryEnableStates(), Is.True);
            read.Begin(new BlockRange(0, 0, 50));
            read.Complete();
            var state = read.KeepState(null);
            Assert.That(() => read.Begin(new BlockRange(0, 20, 10), state), Throws.ArgumentException);
            read.Dispose();
            state.Dispose();
        }
    }
}
