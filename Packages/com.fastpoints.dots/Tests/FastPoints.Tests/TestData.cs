using System;
using System.Collections.Generic;
using System.IO;
using NUnit.Framework;

namespace FastPoints.Tests
{
    public static class TestData
    {
        const string Variable = "FASTPOINTS_DATA", PackageFolder = "Packages/com.fastpoints.dots";

        /// <summary>The data folder, or null if there is none.</summary>
        public static string Root { get; } = FindRoot();

        /// <summary>The package's own folder, or null if the tests run without its sources.</summary>
        public static string PackageRoot { get; } = FindPackage();

        /// <summary>The folder of small sample files, or null.</summary>
        public static string Samples => TryPath("data/samples", out string path) || TryPath("samples", out path) ? path : null;

        public static bool TryPath(string relative, out string path)
        {
            path = Root == null ? null : Path.Combine(Root, relative.Replace('/', Path.DirectorySeparatorChar));
            return path != null && (File.Exists(path) || Directory.Exists(path));
        }

        public static string PathOrIgnore(string relative)
        {
            if (!TryPath(relative, out string path))
                Assert.Ignore(relative + " not present: set " + Variable);
            return path;
        }

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
