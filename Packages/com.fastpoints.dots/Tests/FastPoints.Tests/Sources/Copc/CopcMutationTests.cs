using System;
using System.Collections.Generic;
using FastPoints.Sources;
using FastPoints.Tests.Reading;
using NUnit.Framework;

namespace FastPoints.Tests.Sources
{
    /// <summary>Seeded damage to the info VLR and the hierarchy: whatever comes of it is a failure of one line, or points that
    /// were written, each once, and a warning where some are missing.</summary>
    /// <remarks>More cases: <c>FASTPOINTS_MUTATIONS=1000000 ./test --only CopcMutationTests</c>.</remarks>
    public class CopcMutationTests
    {
        const int Points = 400, Cases = 150, LongCases = 20000, InfoAt = 375 + 54;

        [TestCase(1), TestCase(2), TestCase(99)]
        public void Mutate(int levelsPerPage) => Mutate(levelsPerPage, Cases, levelsPerPage);

        [Test, Category("Long"), Explicit]
        public void Mutate_ManyTimes()
        {
            string cases = Environment.GetEnvironmentVariable("FASTPOINTS_MUTATIONS");
            Mutate(1, int.TryParse(cases, out int count) ? count : LongCases, 77);
        }

        static void Mutate(int levelsPerPage, int cases, int seed)
        {
            var random = new Random(seed);
            var writer = new CopcFileWriter { LevelsPerPage = levelsPerPage, MaxNodePoints = 30 };
            var records = LazRecords.Make(7, 0, Points, seed);
            var sound = writer.Write(records);
            var written = new Dictionary<string, int>();
            foreach (var record in records)
            {
                string text = System.Convert.ToBase64String(record);
                written[text] = written.TryGetValue(text, out int count) ? count + 1 : 1;
            }
            for (int i = 0; i < cases; i++)
            {
                var bytes = (byte[])sound.Clone();
                for (int k = random.Next(1, 4); k > 0; k--)
                    Damage(bytes, writer, random);
                if (random.Next(20) == 0)
                    Array.Resize(ref bytes, random.Next(1, bytes.Length));
                using var file = new TemporaryFile(bytes, ".copc.laz");
                Check(file.Path, writer.RecordBytes, written, "seed " + seed + ", case " + i);
            }
        }

        static void Check(string path, int recordBytes, Dictionary<string, int> written, string detail)
        {
            try
            {
                using var reader = ReadPoints.Open(path);
                var got = LazFileReading.Present(reader, LazFileReading.LayoutOf(path));
                Assert.That(got.Length == Points * recordBytes || reader.Info.Warnings.Count > 0, detail);
                Assert.That(reader.Info.Warnings.Count, Is.LessThan(200), detail);
                var left = new Dictionary<string, int>(written);
                int noise = 0;
                for (int at = 0; at < got.Length; at += recordBytes)
                {
                    string text = System.Convert.ToBase64String(got, at, recordBytes);
                    if (left.TryGetValue(text, out int count) && count > 0)
                        left[text] = count - 1;
                    else
                        noise++;
                }
                Assert.That(noise, Is.EqualTo(0), detail + "\n" + string.Join("\n", reader.Info.Warnings));
            }
            catch (PointCloudException failure)
            {
                Assert.That(failure.Message, Does.Not.Contain("\n"), detail);
                Assert.That(failure.IsInputAtFault, Is.True, detail + ": " + failure.Message);
            }
        }

        static void Damage(byte[] bytes, CopcFileWriter writer, Random random)
        {
            var (offset, count) = writer.Pages[random.Next(writer.Pages.Count)];
            int entry = (int)offset + CopcEntry.Bytes * random.Next(count / CopcEntry.Bytes);
            switch (random.Next(6))
            {
                case 0:
                    bytes[InfoAt + random.Next(72)] ^= (byte)(1 << random.Next(8));
                    break;
                case 1:
                    bytes[entry + random.Next(CopcEntry.Bytes)] ^= (byte)(1 << random.Next(8));
                    break;
                case 2:
                    // A field at an extreme.
                    byte fill = (byte)(random.Next(2) == 0 ? 0 : 255);
                    int field = entry + 4 * random.Next(8);
                    for (int i = 0; i < 4; i++)
                        bytes[field + i] = i == 3 && random.Next(2) == 0 ? (byte)(fill ^ 128) : fill;
                    break;
                case 3:
                    // An entry twice, in place of another.
                    int other = (int)offset + CopcEntry.Bytes * random.Next(count / CopcEntry.Bytes);
                    Array.Copy(bytes, other, bytes, entry, CopcEntry.Bytes);
                    break;
                case 4:
                    // A page in place of a node, at any page.
                    var page = writer.Pages[random.Next(writer.Pages.Count)];
                    BitConverter.GetBytes(page.Offset).CopyTo(bytes, entry + 16);
                    BitConverter.GetBytes(page.Bytes).CopyTo(bytes, entry + 24);
                    BitConverter.GetBytes(CopcEntry.PointCountOfPage).CopyTo(bytes, entry + 28);
                    break;
                default:
                    for (int i = 0; i < CopcEntry.Bytes; i++)
                        bytes[entry + i] = (byte)random.Next(256);
                    break;
            }
        }
    }
}
