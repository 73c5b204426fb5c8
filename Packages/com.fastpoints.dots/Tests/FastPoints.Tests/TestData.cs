using System;
using System.Collections.Generic;
using System.IO;
using NUnit.Framework;

namespace FastPoints.Tests
{
    /// <summary>The one place that knows where real clouds for tests lie: $FASTPOINTS_DATA, or else the folder <c>shared</c>
    /// beside the repository. A test that wants data which is not there is skipped, and says so.</summary>
    public static class TestData
    {
        const string Variable = "FASTPOINTS_DATA", PackageFolder = "Packages/com.fastpoints.dots";

        /// <summary>The data folder, or null where there is none.</summary>
        public static string Root { get; } = FindRoot();

        /// <summary>The package's own folder, or null where the tests run without its sources.</summary>
        public static string PackageRoot { get; } = FindPackage();

        /// <summary>The folder of small sample files, or null.</summary>
        public static string Samples => TryPath("data/samples", out string path) || TryPath("samples", out path) ? path : null;

        /// <summary>Whether a file or folder is there.</summary>
        public static bool TryPath(string relative, out string path)
        {
            path = Root == null ? null : Path.Combine(Root, relative.Replace('/', Path.DirectorySeparatorChar));
            return path != null && (File.Exists(path) || Directory.Exists(path));
        }

        /// <summary>A file or folder; the test is skipped where it is absent.</summary>
        public static string PathOrIgnore(string relative)
        {
            if (!TryPath(relative, out string path))
                Assert.Ignore(relative + " not present: set " + Variable);
            return path;
        }

        /// <summary>A file under the samples; the test is skipped where it is absent.</summary>
        public static string SampleOrIgnore(string relative)
        {
            string path = Samples == null ? null : Path.Combine(Samples, relative.Replace('/', Path.DirectorySeparatorChar));
            if (path == null || !File.Exists(path))
                Assert.Ignore("samples/" + relative + " not present: set " + Variable);
            return path;
        }

        static string FindRoot()
        {
            string named = Environment.GetEnvironmentVariable(Variable);
            if (!string.IsNullOrEmpty(named))
                return Directory.Exists(named) ? Path.GetFullPath(named) : null;
            string package = FindPackage();
            if (package == null)
                return null;
            string beside = Path.GetFullPath(Path.Combine(package, "..", "..", "..", "shared"));
            return Directory.Exists(beside) ? beside : null;
        }

        static string FindPackage()
        {
            foreach (string start in new List<string> { AppDomain.CurrentDomain.BaseDirectory, Directory.GetCurrentDirectory() })
                for (var folder = new DirectoryInfo(start); folder != null; folder = folder.Parent)
                    if (Directory.Exists(Path.Combine(folder.FullName, PackageFolder)))
                        return Path.Combine(folder.FullName, PackageFolder);
            return null;
        }
    }
}
