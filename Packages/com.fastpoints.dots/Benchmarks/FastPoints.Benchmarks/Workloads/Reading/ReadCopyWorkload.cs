using System;
using System.IO;
using FastPoints.Sources;

namespace FastPoints.Benchmarks
{
    /// <summary>The limit of a <see cref="ColumnsWorkload"/> of compressed points: its files are read, and as many bytes copied
    /// as its columns have, on one thread.</summary>
    sealed class ReadCopyWorkload : IWorkload
    {
        const int BufferBytes = 1 << 20;

        readonly Func<WorkloadContext, string> m_find;
        string m_path;
        byte[] m_from, m_to;

        /// <param name="find">The path; null if there is none.</param>
        public ReadCopyWorkload(string name, Func<WorkloadContext, string> find) => (Name, m_find) = (name, find);

        public string Name { get; }
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            m_path = m_find(context);
            m_from = new byte[BufferBytes];
            m_to = new byte[BufferBytes];
            Run();
        }

        public WorkloadResult Run()
        {
            if (m_path == null)
                return default;
            long points, bytes;
            using (var reader = PointReaders.Open(m_path))
            {
                JobCoroutine.RunToEnd(reader.IndexBlocks());
                points = reader.PointCount;
                bytes = points * reader.Info.Schema.BytesPerPoint;
            }
            foreach (string file in FilesOf(m_path))
                using (var stream = new FileStream(file, FileMode.Open, FileAccess.Read, FileShare.Read, 1))
                    while (stream.Read(m_to, 0, m_to.Length) > 0) { }
            for (long at = 0; at < bytes; at += BufferBytes)
                Buffer.BlockCopy(m_from, 0, m_to, 0, (int)Math.Min(BufferBytes, bytes - at));
            return new WorkloadResult { Points = points, Bytes = BytesOf(m_path) };
        }

        public void Dispose() { }

        public static long BytesOf(string path)
        {
            long bytes = 0;
            foreach (string file in FilesOf(path))
                bytes += new FileInfo(file).Length;
            return bytes;
        }

        static string[] FilesOf(string path) =>
            Directory.Exists(path) ? Directory.GetFiles(path, "*", SearchOption.AllDirectories) : new[] { path };
    }
}
