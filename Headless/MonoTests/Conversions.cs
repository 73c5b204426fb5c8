using System.Security.Cryptography;
using FastPoints.Build;
using FastPoints.Nodes;
using FastPoints.Reading;
using FastPoints.Scenes;
using FastPoints.Sources;
using FastPoints.Tests;

namespace FastPoints.MonoTests
{
    internal static class Conversions
    {
        private const int SeededPoints = 300_000;

        public static int Run(string scratch)
        {
            Directory.CreateDirectory(scratch);
            string target = Path.Combine(scratch, "c.fastpoints");
            foreach (string source in Seeded(scratch).Concat(Samples()))
                foreach (Sampler sampler in (Sampler[])Enum.GetValues(typeof(Sampler)))
                    Console.WriteLine(Name(source) + "\t" + sampler + "\t" + Convert(source, sampler, target));
            return 0;
        }

        /// <summary>Written here, so that these bytes are compared as well.</summary>
        private static IEnumerable<string> Seeded(string scratch)
        {
            foreach (ScanOrder order in (ScanOrder[])Enum.GetValues(typeof(ScanOrder)))
            {
                string path = Path.Combine(scratch, order + ".las");
                JobCoroutine.RunToEnd(LasScan.Run(path, SeededPoints, 1 + (uint)order, order, null));
                Console.WriteLine(Name(path) + "\twritten\t" + Hash(File.ReadAllBytes(path)));
                yield return path;
            }
        }

        private static IEnumerable<string> Samples()
        {
            if (TestData.Samples == null)
                yield break;
            foreach (string kind in new[] { "las", "laz", "ply", "copc", "broken" })
                foreach (string file in Sorted(Directory.GetFiles(Path.Combine(TestData.Samples, kind))))
                    yield return file;
            foreach (string kind in new[] { "ept", "potree" })
                foreach (string folder in Sorted(Directory.GetDirectories(Path.Combine(TestData.Samples, kind))))
                    yield return folder;
        }

        private static IEnumerable<string> Sorted(string[] paths) => paths.OrderBy(p => p, StringComparer.Ordinal);

        private static string Name(string path) => Path.GetFileName(Path.GetDirectoryName(path)) is "seeded"
            ? Path.GetFileName(path) : Path.GetFileName(Path.GetDirectoryName(path)) + "/" + Path.GetFileName(path);

        private static string Convert(string source, Sampler sampler, string target)
        {
            try
            {
                using PointReader reader = PointReaders.Open(source);
                JobCoroutine.RunToEnd(ConvertCloud.Run(new[] { reader }, target,
                    new ConvertSettings { Sampler = sampler }, _ => { }, null));
                string reported = string.Join("\n",
                    reader.Info.Facts.Select(f => f.ToString()).Concat(reader.Info.Warnings.Select(w => w.Text)));
                return Hashes(target) + " told:" + Hash(System.Text.Encoding.UTF8.GetBytes(reported));
            }
            catch (PointCloudException e)
            {
                return e.Message.Replace('\n', ' ');
            }
            finally
            {
                if (Directory.Exists(target))
                    Directory.Delete(target, true);
            }
        }

        private static string Hashes(string folder) =>
            string.Join(" ", Sorted(Directory.GetFiles(folder, "*", SearchOption.AllDirectories))
            .Select(f => f.Substring(folder.Length + 1).Replace('\\', '/') + ":" + Hash(File.ReadAllBytes(f))));

        private static string Hash(byte[] bytes)
        {
            using (var sha = SHA256.Create())
                return BitConverter.ToString(sha.ComputeHash(bytes), 0, 8).Replace("-", "");
        }
    }
}
