using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using FastPoints.Base;
using FastPoints.Files;
using FastPoints.Tests.Support;
using NUnit.Framework;
using Unity.Collections;

namespace FastPoints.Tests.Files
{
    /// <summary>Seeded damage to small trees: flipped bits, cuts, insertions, fields at their extremes, in any of their files.
    /// Whatever comes of it is a cloud (of no more points than the bytes can hold) or a
    /// <see cref="PointCloudException"/>.</summary>
    /// <remarks>The long ones take their number of cases from $FASTPOINTS_MUTATIONS.</remarks>
    public class PotreeMutationTests
    {
        const string CasesVariable = "FASTPOINTS_MUTATIONS";
        const int UsualCases = 150;
        const int LongCases = 5000;

        /// <summary>Points of a byte: see <see cref="Potree2Reader"/>.</summary>
        const int MostPointsPerByte = 1000;

        [TestCase("1.4", 1), TestCase("1.7", 2), TestCase("1.8", 3), TestCase("DEFAULT", 4), TestCase("BROTLI", 5)]
        public void Mutate(string kind, int seed) => Mutate(kind, seed, UsualCases);

        [Test, Category("Long"), Explicit]
        public void Mutate_ManyTimes([Values("1.4", "1.7", "1.8", "DEFAULT", "BROTLI")] string kind) => Mutate(kind, 1000,
            int.TryParse(Environment.GetEnvironmentVariable(CasesVariable), out int cases) ? cases / 5 : LongCases);

        static void Mutate(string kind, int seed, int cases)
        {
            var random = new Random(seed);
            using var folder = new PotreeTestFolder();
            var cloud = new PotreeTestCloud(120, 3, seed);
            if (kind.StartsWith("1."))
                new Potree1Writer { Version = kind, StepSize = 1 }.Write(folder, cloud);
            else
                new Potree2Writer { IsBrotli = kind == "BROTLI", StepSize = 1 }.Write(folder, cloud);
            var files = Directory.GetFiles(folder.Folder, "*", SearchOption.AllDirectories).OrderBy(path => path,
                StringComparer.Ordinal).ToList();
            // The index and the hierarchies are what most depends on, so they are hit most.
            var indexes = files.Where(path => !path.EndsWith(".bin") || path.EndsWith("hierarchy.bin")).ToList();
            for (int i = 0; i < cases; i++)
            {
                string path = random.Next(4) == 0 ? files[random.Next(files.Count)] : indexes[random.Next(indexes.Count)];
                var sound = File.ReadAllBytes(path);
                File.WriteAllBytes(path, Damage(sound, random));
                ReadWhatIsThere(folder.Folder, files, "seed " + seed + ", case " + i + ", " + Path.GetFileName(path));
                File.WriteAllBytes(path, sound);
            }
        }

        static void ReadWhatIsThere(string folder, List<string> files, string story)
        {
            long bytes = files.Sum(path => new FileInfo(path).Length);
            try
            {
                using var reader = PotreeTwins.Open(folder);
                Assert.That(reader.PointCount, Is.LessThanOrEqualTo(bytes * MostPointsPerByte), story);
                Assert.That(reader.Tree.NodeCount, Is.LessThanOrEqualTo(bytes / 5), story);
                if (reader.BlockCount == 0)
                    return;
                long got = 0;
                using (var read = reader.CreateRead(reader.Info.Schema, reader.MaxPointsPerBlock, Allocator.Persistent))
                    for (int block = 0; block < reader.BlockCount; block++)
                    {
                        int count = reader.PointsInBlock(block);
                        read.Begin(new BlockRange(block, 0, count));
                        read.Complete();
                        got += read.Points.Count;
                        Assert.That(read.Points.Count, Is.InRange(0, count), story);
                    }
                if (got < reader.PointCount)
                    Assert.That(reader.Info.Warnings, Is.Not.Empty, story);
                Assert.That(reader.Info.Warnings.Count, Is.LessThan(100), story);
            }
            catch (PointCloudException failure)
            {
                Assert.That(failure.Message, Does.Not.Contain("\n"), story);
                Assert.That(failure.IsBadInput || failure.Code == FailureCode.NotFound, Is.True, story + ": " + failure.Message);
            }
        }

        static byte[] Damage(byte[] sound, Random random)
        {
            var bytes = (byte[])sound.Clone();
            if (bytes.Length == 0)
                return new byte[random.Next(20)];
            int at = random.Next(bytes.Length);
            switch (random.Next(5))
            {
                case 0:
                    return bytes.Take(at).ToArray();
                case 1:
                    for (int i = random.Next(1, 8); i > 0; i--)
                        bytes[random.Next(bytes.Length)] ^= (byte)(1 << random.Next(8));
                    return bytes;
                case 2:
                    byte fill = (byte)(random.Next(2) == 0 ? 255 : random.Next(256));
                    for (int i = at; i < Math.Min(bytes.Length, at + random.Next(1, 9)); i++)
                        bytes[i] = fill;
                    return bytes;
                case 3:
                    return bytes.Take(at).Concat(bytes.Skip(at).Take(random.Next(60))).Concat(bytes.Skip(at)).ToArray();
                default:
                    // A digit in a text, a byte elsewhere.
                    for (int i = 0; i < bytes.Length; i++)
                        if (bytes[(at + i) % bytes.Length] >= '0' && bytes[(at + i) % bytes.Length] <= '9')
                        {
                            bytes[(at + i) % bytes.Length] = (byte)"0123456789-e"[random.Next(12)];
                            break;
                        }
                    return bytes;
            }
        }
    }
}
