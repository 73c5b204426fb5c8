using System;
using System.IO;

namespace FastPoints.Tests.Support
{
    /// <summary>A folder for a test's tree, gone when disposed.</summary>
    public class PotreeTestFolder : IDisposable
    {
        public PotreeTestFolder()
        {
            Folder = Path.Combine(Path.GetTempPath(), "fastpoints-" + Guid.NewGuid().ToString("N"));
            Directory.CreateDirectory(Folder);
        }

        public string Folder { get; protected set; }

        public string File(string relative) => Path.Combine(Folder, relative.Replace('/', Path.DirectorySeparatorChar));

        public void Write(string relative, byte[] bytes)
        {
            string path = File(relative);
            Directory.CreateDirectory(Path.GetDirectoryName(path));
            System.IO.File.WriteAllBytes(path, bytes);
        }

        public void Write(string relative, string text) => Write(relative, System.Text.Encoding.UTF8.GetBytes(text));

        /// <summary>Renames the folder.</summary>
        public void Move()
        {
            string other = Folder + " moved";
            Directory.Move(Folder, other);
            Folder = other;
        }

        public void Dispose() => Directory.Delete(Folder, true);
    }
}
