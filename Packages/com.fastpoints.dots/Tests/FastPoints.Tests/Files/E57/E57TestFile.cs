using System;
using System.IO;

namespace FastPoints.Tests.Files
{
    /// <summary>Bytes as a file in the temporary folder, gone when disposed.</summary>
    sealed class E57TestFile : IDisposable
    {
        public E57TestFile(byte[] bytes)
        {
            Path = System.IO.Path.Combine(System.IO.Path.GetTempPath(), "fastpoints-" + Guid.NewGuid().ToString("N") + ".e57");
            File.WriteAllBytes(Path, bytes);
        }

        public string Path { get; }

        public void Dispose() => File.Delete(Path);
    }
}
