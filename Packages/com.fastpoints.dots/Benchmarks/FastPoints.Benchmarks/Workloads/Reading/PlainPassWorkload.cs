using System;
using System.IO;
using System.Runtime.InteropServices;
using System.Threading;
using Unity.Jobs.LowLevel.Unsafe;

namespace FastPoints.Benchmarks
{
    /// <summary>A pass over a file by plain threads and plain reads, without jobs, containers or any of the package: what the
    /// reader is compared with. As many threads as the job system has, each taking the next segment.</summary>
    sealed unsafe class PlainPassWorkload : IWorkload
    {
        public const int SegmentPoints = 32768;
        public delegate void DecodeSegment(byte* source, byte* target, int points);

        readonly Func<WorkloadContext, string> m_find;
        readonly int m_recordBytes;
        readonly DecodeSegment m_decode;
        string m_path;
        int m_points;

        /// <param name="decode">Null to copy the bytes as they are.</param>
        public PlainPassWorkload(string name, string limitName, Func<WorkloadContext, string> find, int recordBytes,
            DecodeSegment decode = null)
        {
            (Name, LimitName) = (name, limitName);
            (m_find, m_recordBytes, m_decode) = (find, recordBytes, decode);
        }

        public string Name { get; }
        public string LimitName { get; }

        public void Prepare(WorkloadContext context)
        {
            (m_path, m_points) = (m_find(context), context.Points);
            Run();
        }

        public WorkloadResult Run()
        {
            long bytes = new FileInfo(m_path).Length, next = -1;
            var threads = new Thread[JobsUtility.JobWorkerCount + 1];
            for (int i = 0; i < threads.Length; i++)
            {
                threads[i] = new Thread(() => TakeSegments(bytes, ref next));
                threads[i].Start();
            }
            foreach (var thread in threads)
                thread.Join();
            return new WorkloadResult { Points = m_points, Bytes = bytes };
        }

        public void Dispose() { }

        void TakeSegments(long bytes, ref long next)
        {
            int segment = SegmentPoints * m_recordBytes;
            byte* source = (byte*)Marshal.AllocHGlobal(segment), target = (byte*)Marshal.AllocHGlobal(segment);
            using (var stream = new FileStream(m_path, FileMode.Open, FileAccess.Read, FileShare.Read, 1))
                for (long offset; (offset = Interlocked.Increment(ref next) * segment) < bytes;)
                {
                    stream.Position = offset;
                    int count = 0, got;
                    while ((got = stream.Read(new Span<byte>(source + count, segment - count))) > 0)
                        count += got;
                    if (m_decode != null)
                        m_decode(source, target, count / m_recordBytes);
                    else
                        Buffer.MemoryCopy(source, target, segment, count);
                }
            Marshal.FreeHGlobal((IntPtr)source);
            Marshal.FreeHGlobal((IntPtr)target);
        }
    }
}
