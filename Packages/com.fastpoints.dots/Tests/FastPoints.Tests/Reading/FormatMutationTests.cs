using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using FastPoints.Laz;
using FastPoints.Reading;
using FastPoints.Sources;
using FastPoints.Text;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Tests.Reading
{
    /// <remarks>The stress command, a million damaged clouds over all formats: <c>FASTPOINTS_MUTATIONS=1000000 ./test --only
    /// FormatMutationTests.Mutate_ManyTimes</c>. Without the variable: 20,000. FASTPOINTS_MUTATIONS_SEED takes other cases than
    /// those of seed 7.</remarks>
    public class FormatMutationTests : FolderTests
    {
        const int Cases = 120, SampleCases = 8, LongCases = 20000, MaxPoints = 3000;
        const int MaxBlocks = 6;

        static IEnumerable<FormatFixture> Fixtures() => FormatFixture.All;

        [TestCaseSource(nameof(Fixtures))]
        public void Mutate(FormatFixture fixture) => Mutate(fixture, fixture.IsSample ? SampleCases : Cases, 1, 1);

        [TestCaseSource(nameof(Fixtures)), Category("Long"), Explicit]
        public void Mutate_ManyTimes(FormatFixture fixture)
        {
            int cases = Number("FASTPOINTS_MUTATIONS", LongCases), own = FormatFixture.All.Count(f => !f.IsSample);
            int ofThis = fixture.IsSample ? Math.Max(1, cases / 1000) : (cases + own - 1) / own;
            int readable = Mutate(fixture, ofThis, Number("FASTPOINTS_MUTATIONS_SEED", 7), fixture.IsSample ? 0 : 1);
            TestContext.Progress.WriteLine(fixture + ": " + ofThis + " damaged clouds, " + readable +
                " of them read to their end");
        }

        static int Number(string variable, int fallback) =>
            int.TryParse(Environment.GetEnvironmentVariable(variable), out int number) ? number : fallback;

        int Mutate(FormatFixture fixture, int cases, int seed, int minReadable)
        {
            Directory.Delete(Folder.Path, true);
            Directory.CreateDirectory(Folder.Path);
            string main = fixture.Write(Folder.Path);
            var sound = Directory.GetFiles(Folder.Path, "*", SearchOption.AllDirectories).OrderBy(p => p, StringComparer.Ordinal)
                .Select(p => (Path: p, Bytes: File.ReadAllBytes(p))).ToList();
            var indexes = sound.Where(f => f.Path == main || IsIndex(f.Path)).ToList();
            var telling = sound.ToDictionary(f => f.Path, f => KeyFields.Of(f.Bytes));
            Assert.That(Reads(main, "as it is"), Is.True, fixture + " as it is");
            var random = new System.Random(seed);
            int readable = 0;
            for (int i = 0; i < cases; i++)
            {
                // Among many files, mostly the index and hierarchy pages, which describe the others.
                int choice = random.Next(3);
                var (path, bytes) = choice == 0 ? sound.First(f => f.Path == main)
                    : choice == 1 ? indexes[random.Next(indexes.Count)] : sound[random.Next(sound.Count)];
                var damaged = random.Next(3) == 0 ? DamageTelling(bytes, telling[path], random)
                    : Damage.Of(bytes, random, null, fixture.Words);
                if (fixture.Seal != null && random.Next(2) == 0 && damaged.Length >= 1024)
                {
                    Array.Resize(ref damaged, damaged.Length / 1024 * 1024);
                    fixture.Seal(damaged);
                }
                File.WriteAllBytes(path, damaged);
                if (Reads(main, fixture + ", seed " + seed + ", case " + i))
                    readable++;
                if (sound.Count > 1)
                    File.WriteAllBytes(path, bytes);
            }
            Assert.That(readable, Is.GreaterThanOrEqualTo(minReadable), fixture.ToString());
            return readable;
        }

        static bool IsIndex(string path) => path.EndsWith(".json") || path.EndsWith(".js") || path.EndsWith(".hrc")
            || Path.GetFileName(path) == "hierarchy.bin";

        static byte[] DamageTelling(byte[] sound, List<(int At, int Bytes)> places, System.Random random)
        {
            var bytes = (byte[])sound.Clone();
            if (bytes.Length == 0)
                return bytes;
            for (int change = random.Next(1, 3); change > 0; change--)
            {
                int at = Place(bytes, places, random), other = Place(bytes, places, random);
                switch (random.Next(3))
                {
                    case 0:
                        long[] numbers = { 0, 1, -1, int.MaxValue, 1L << 31, uint.MaxValue, 4000000000, bytes.Length,
                            bytes.Length - 1, at, other, long.MaxValue };
                        var number = BitConverter.GetBytes(numbers[random.Next(numbers.Length)]);
                        Array.Copy(number, 0, bytes, at, Math.Min(random.Next(2) == 0 ? 4 : 8, bytes.Length - at));
                        break;
                    case 1:
                        int width = 4 << random.Next(4);
                        Array.Copy(sound, other, bytes, at, Math.Min(width, bytes.Length - Math.Max(at, other)));
                        break;
                    default:
                        ReplaceDigits(bytes, at, random);
                        break;
                }
            }
            return bytes;
        }

        static int Place(byte[] bytes, List<(int At, int Bytes)> places, System.Random random)
        {
            if (places.Count == 0)
                return random.Next(bytes.Length);
            var (at, length) = places[random.Next(places.Count)];
            return at + random.Next((length + 3) / 4) * 4;
        }

        static void ReplaceDigits(byte[] bytes, int at, System.Random random)
        {
            while (at < bytes.Length && !char.IsDigit((char)bytes[at]))
                at++;
            int kind = random.Next(4);
            for (int i = at; i < bytes.Length && char.IsDigit((char)bytes[i]); i++)
                bytes[i] = (byte)(kind == 0 ? '9' : kind == 1 ? '0' : i == at && kind == 2 ? '-' : '0' + random.Next(10));
        }

        static bool Reads(string path, string detail)
        {
            try
            {
                using var reader = PointReaders.Open(path);
                ReadPoints.IndexBlocks(reader);
                long bytes = Directory.GetFiles(Path.GetDirectoryName(path), "*", SearchOption.AllDirectories)
                    .Sum(file => new FileInfo(file).Length);
                Assert.That(reader.Info.Warnings.Count, Is.LessThan(300), detail);
                Assert.That(reader.Info.Facts.Count, Is.LessThan(300 + bytes / 32), detail);
                Assert.That(reader.PointCount, Is.LessThanOrEqualTo(LazChunk.MaxPoints(bytes) + reader.BlockCount), detail);
                Assert.That(reader.Tree?.NodeCount ?? 0, Is.LessThanOrEqualTo(bytes / 5), detail);
                Assert.That(math.all(math.isfinite(reader.Info.Transform.Scale)), Is.True, detail);
                if (reader.BlockCount == 0)
                    return true;
                int capacity = Math.Min(MaxPoints, reader.MaxPointsPerBlock);
                using (var read = reader.CreateRead(reader.Info.Schema, capacity, Allocator.Persistent))
                    for (int i = 0; i < Math.Min(MaxBlocks, reader.BlockCount); i++)
                    {
                        int block = (int)((long)i * reader.BlockCount / Math.Min(MaxBlocks, reader.BlockCount));
                        int count = Math.Min(capacity, reader.PointsInBlock(block));
                        read.Begin(new BlockRange(block, 0, count));
                        read.Complete();
                        Assert.That(read.Points.Count, Is.InRange(0, count), detail);
                        // Remarks and places without a return are lines, and no points, and nothing is wrong with them.
                        bool hasRemarks = reader is XyzReader || reader is PtxReader;
                        if (read.Points.Count < count && !hasRemarks)
                            Assert.That(reader.Info.Warnings, Is.Not.Empty, detail);
                    }
                return true;
            }
            catch (PointCloudException failure)
            {
                Assert.That(failure.Message, Does.Not.Contain("\n"), detail);
                bool isInput = failure.IsInputAtFault || failure.Code == FailureCode.ReadFailed ||
                    failure.Code == FailureCode.NotFound;
                Assert.That(isInput, Is.True, detail + ": " + failure.Message);
                return false;
            }
            catch (Exception e) when (!(e is ResultStateException))
            {
                throw new AssertionException(detail + ": " + e, e);
            }
        }
    }
}
