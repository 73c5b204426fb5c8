using System;
using System.IO;
using System.Runtime.InteropServices;
using System.Threading;
using Unity.Jobs.LowLevel.Unsafe;

namespace FastPoints.Benchmarks
{
    /// <summary>
    /// The file of <see cref="LasColumnsWorkload"/> read and copied once by plain threads, as many as the job system has: its
    /// bound.
    /// </summary>
    public struct LasReadCopyWorkload : IWorkload
    {
        string m_path;

        public string Name => "las read and copy";
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            m_path = LasBenchmarkFile.Make(context);
            Run();
        }

        public WorkloadResult Run()
        {
            string path = m_path;
            long bytes = new FileInfo(path).Length;
            long next = -1;
            var threads = new Thread[JobsUtility.JobWorkerCount + 1];
            for (int i = 0; i < threads.Length; i++)
            {
                threads[i] = new Thread(() => ReadAndCopy(path, bytes, ref next));
                threads[i].Start();
            }
            foreach (var thread in threads)
                thread.Join();
            return new WorkloadResult { Points = bytes / LasBenchmarkFile.RecordBytes, Bytes = bytes };
        }

        public void Dispose()
        {
        }

        /// <summary>Takes one stretch after the other until none is left.</summary>
        static unsafe void ReadAndCopy(string path, long bytes, ref long next)
        {
            const int Stretch = LasBenchmarkFile.BlockPoints * LasBenchmarkFile.RecordBytes;
            byte* source = (byte*)Marshal.AllocHGlobal(Stretch);
            byte* target = (byte*)Marshal.AllocHGlobal(Stretch);
            using (var stream = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.Read, 1))
            {
                long offset;
                while ((offset = Interlocked.Increment(ref next) * Stretch) < bytes)
                {
                    stream.Position = offset;
                    int count = 0, got;
                    while ((got = stream.Read(new Span<byte>(source + count, Stretch - count))) > 0)
                        count += got;
                    Buffer.MemoryCopy(source, target, Stretch, count);
                }
            }
            Marshal.FreeHGlobal((IntPtr)source);
            Marshal.FreeHGlobal((IntPtr)target);
        }
    }
}
