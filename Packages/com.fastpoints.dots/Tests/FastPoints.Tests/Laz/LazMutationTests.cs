using System;
using FastPoints.Las;
using FastPoints.Laz;
using NUnit.Framework;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Tests.Laz
{
    /// <summary>Chunks on their own; whole files are cases of FormatMutationTests.</summary>
    /// <remarks>The long ones take their number of cases from $FASTPOINTS_MUTATIONS, so that a million can be run:
    /// <c>FASTPOINTS_MUTATIONS=1000000 ./test --only LazMutationTests</c>.</remarks>
    public unsafe class LazMutationTests
    {
        const string CasesVariable = "FASTPOINTS_MUTATIONS";
        const int CasesPerChunk = 400, LongCases = 20000;

        [TestCase(0), TestCase(3), TestCase(5), TestCase(6), TestCase(8), TestCase(10)]
        public void MutateChunk(int format) => MutateChunks(format, CasesPerChunk, format);

        [Test, Category("Long"), Explicit]
        public void MutateChunk_ManyTimes([Range(0, 10)] int format) => MutateChunks(format, Cases() / 11, 7000 + format);

        static int Cases() => int.TryParse(Environment.GetEnvironmentVariable(CasesVariable), out int cases) ? cases : LongCases;

        static void MutateChunks(int format, int cases, int seed)
        {
            var random = new Random(seed);
            int recordBytes = LasPointFormat.Of(format).RecordBytes + 3;
            for (int i = 0; i < cases; i++)
            {
                var items = LazItems.Of(format, format < 6 ? 1 + i % 2 : 3 + i % 2, 3);
                var sound = items[0].Version == 1 ? FirstVersionChunk(format, 500 + i)
                    : LazEncoder.Chunk(items, LazRecords.Make(format, 3, 20 + i % 50, seed + i));
                for (int k = 0; k < 4; k++)
                    DecodeWithinBounds(items, recordBytes, Damage.Of(sound, random), 200, "seed " + seed + ", case " + i);
            }
        }

        static byte[] FirstVersionChunk(int format, int bytes)
        {
            var file = LazFileReading.FirstVersion("format" + format);
            int chunk = RecordFields.Int32(file, LasHeader.At.PointsOffset) + LazChunkTable.TableOffsetSize;
            return file.AsSpan(chunk, bytes).ToArray();
        }

        /// <summary>Decodes with marked memory behind the state and the tile, which must stay as it is.</summary>
        static void DecodeWithinBounds(LazItem[] items, int recordBytes, byte[] chunk, int points, string detail)
        {
            const int Guard = 4096;
            const byte Mark = 0xA5;
            bool isLayered = items[0].IsLayered;
            var layers = isLayered ? LazLayer.Of(items) : null;
            var isWanted = isLayered ? new bool[layers.Length] : null;
            for (int i = 0; isLayered && i < isWanted.Length; i++)
                isWanted[i] = true;
            long stateBytes = isLayered ? LayeredChunk.StateBytes(layers, isWanted, recordBytes)
                : PointwiseChunk.StateBytes(items);
            using var state = Marked((int)stateBytes, Guard, Mark);
            using var tile = Marked(points * recordBytes, Guard, Mark);
            using var input = Marked(chunk.Length, RangeCoder.PaddingBytes, Mark);
            NativeArray<byte>.Copy(chunk, input, chunk.Length);
            byte* at = (byte*)input.GetUnsafePtr();
            byte* location = (byte*)state.GetUnsafePtr();
            byte* records = (byte*)tile.GetUnsafePtr();
            int got;
            if (isLayered)
            {
                LayeredChunk.Configure((LayeredChunk*)location, layers, isWanted, recordBytes);
                LayeredChunk.Start((LayeredChunk*)location, at, chunk.Length, true, points);
                got = LayeredChunk.Decode((LayeredChunk*)location, at, records, points);
            }
            else
            {
                PointwiseChunk.Configure((PointwiseChunk*)location, items, recordBytes);
                PointwiseChunk.Start((PointwiseChunk*)location);
                got = PointwiseChunk.Decode((PointwiseChunk*)location, at, chunk.Length, records, points);
            }
            Assert.That(got, Is.InRange(0, points), detail);
            Assert.That(IsMarked(state, (int)stateBytes, Mark), Is.True, detail + ": wrote behind the state");
            Assert.That(IsMarked(tile, points * recordBytes, Mark), Is.True, detail + ": wrote behind the tile");
            Assert.That(IsMarked(input, chunk.Length, Mark), Is.True, detail + ": wrote behind the input");
        }

        static NativeArray<byte> Marked(int bytes, int guard, byte mark)
        {
            var array = new NativeArray<byte>(bytes + guard, Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
            UnsafeUtility.MemSet((byte*)array.GetUnsafePtr() + bytes, mark, guard);
            return array;
        }

        static bool IsMarked(NativeArray<byte> array, int first, byte mark)
        {
            byte* bytes = (byte*)array.GetUnsafePtr();
            for (int i = first; i < array.Length; i++)
                if (bytes[i] != mark)
                    return false;
            return true;
        }
    }
}
