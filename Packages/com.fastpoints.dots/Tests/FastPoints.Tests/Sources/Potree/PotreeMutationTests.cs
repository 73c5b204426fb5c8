using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using FastPoints.Reading;
using FastPoints.Tests.Reading;
using NUnit.Framework;
using Unity.Collections;

namespace FastPoints.Tests.Sources
{
    /// <remarks>The long ones take their number of cases from $FASTPOINTS_MUTATIONS.</remarks>
    public class PotreeMutationTests
    {
        const string CasesVariable = "FASTPOINTS_MUTATIONS";
        const int DefaultCases = 150, LongCases = 5000;
        const int MaxPointsPerByte = 1000;

        [TestCase("1.4", 1), TestCase("1.7", 2), TestCase("1.8", 3), TestCase("DEFAULT", 4), TestCase("BROTLI", 5)]
        public void Mutate(string kind, int seed) => Mutate(kind, seed, DefaultCases);

        [Test, Category("Long"), Explicit]
        public void Mutate_ManyTimes([Values("1.4", "1.7", "1.8", "DEFAULT", "BROTLI")] string kind) => Mutate(kind, 1000,
            int.TryParse(Environment.GetEnvironmentVariable(CasesVariable), out int cases) ? cases / 5 : LongCases);

        static void Mutate(string kind, int seed, int cases)
        {
            var random = new Random(seed);
            using var folder = new TemporaryFolder();
            var cloud = new PotreeTestCloud(120, 3, seed);
            if (kind.StartsWith("1."))
                new Potree1Writer { Version = kind, StepSize = 1 }.Write(folder, cloud);
            else
                new Potree2Writer { IsBrotli = kind == "BROTLI", StepSize = 1 }.Write(folder, cloud);
            var files = Directory.GetFiles(folder.Path, "*", SearchOption.AllDirectories).OrderBy(path => path,
                StringComparer.Ordinal).ToList();
            // The index and the hierarchies are what most depends on, so they are hit most.
            var indexes = files.Where(path => !path.EndsWith(".bin") || path.EndsWith("hierarchy.bin")).ToList();
            for (int i = 0; i < cases; i++)
            {
                string path = random.Next(4) == 0 ? files[random.Next(files.Count)] : indexes[random.Next(indexes.Count)];
                var sound = File.ReadAllBytes(path);
                File.WriteAllBytes(path, sound.Length == 0 ? new byte[random.Next(20)] : Damage.Of(sound, random));
                ReadWhatIsThere(folder.Path, files, "seed " + seed + ", case " + i + ", " + Path.GetFileName(path));
                File.WriteAllBytes(path, sound);
            }
        }

        static void ReadWhatIsThere(string folder, List<string> files, string detail)
        {
            long bytes = files.Sum(path => new FileInfo(path).Length);
            try
            {
                using var reader = ReadPoints.Open(folder);
                Assert.That(reader.PointCount, Is.LessThanOrEqualTo(bytes * MaxPointsPerByte), detail);
                Assert.That(reader.Tree.NodeCount, Is.LessThanOrEqualTo(bytes / 5), detail);
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
                        Assert.That(read.Points.Count, Is.InRange(0, count), detail);
                    }
                if (got < reader.PointCount)
                    Assert.That(reader.Info.Warnings, Is.Not.Empty, detail);
                Assert.That(reader.Info.Warnings.Count, Is.LessThan(100), detail);
            }
            catch (PointCloudException failure)
            {
                Assert.That(failure.Message, Does.Not.Contain("\n"), detail);
                Assert.That(failure.IsBadInput || failure.Code == FailureCode.NotFound, Is.True, detail + ": " + failure.Message);
            }
        }
    }
}
