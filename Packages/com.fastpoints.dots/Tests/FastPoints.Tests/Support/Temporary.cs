using System;
using System.IO;
using System.Text;
using NUnit.Framework;

namespace FastPoints.Tests
{
    /// <summary>A name in the temporary folder; a file of that name is gone when disposed.</summary>
    public class TemporaryFile : IDisposable
    {
        public TemporaryFile(string extension = "") => Path = TemporaryFolder.NewPath() + extension;

        public TemporaryFile(byte[] bytes, string extension = "") : this(extension) => File.WriteAllBytes(Path, bytes);

        public string Path { get; }

        public void Dispose() => File.Delete(Path);
    }

    public sealed class TemporaryFolder : IDisposable
    {
        public TemporaryFolder() => Directory.CreateDirectory(Path = NewPath());

        public static string NewPath() =>
            System.IO.Path.Combine(System.IO.Path.GetTempPath(), "fastpoints-" + Guid.NewGuid().ToString("N"));

        public string Path { get; private set; }

        public string File(string relative) =>
            System.IO.Path.Combine(Path, relative.Replace('/', System.IO.Path.DirectorySeparatorChar));

        public string Write(string relative, byte[] bytes)
        {
            string path = File(relative);
            Directory.CreateDirectory(System.IO.Path.GetDirectoryName(path));
            System.IO.File.WriteAllBytes(path, bytes);
            return path;
        }

        public string Write(string relative, string text) => Write(relative, Encoding.UTF8.GetBytes(text));

        public void Move()
        {
            Directory.Move(Path, Path + " moved");
            Path += " moved";
        }

        public void Dispose()
        {
            FileChanges.AwaitDeletes();
            Directory.Delete(Path, true);
        }
    }

    public abstract class FolderTests
    {
        protected TemporaryFolder Folder { get; private set; }

        [SetUp]
        public void MakeFolder() => Folder = new TemporaryFolder();

        [TearDown]
        public void DeleteFolder() => Folder.Dispose();
    }
}
