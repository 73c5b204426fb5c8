using System;
using System.IO;
using System.Runtime.InteropServices;
using System.Threading;
using Unity.Jobs.LowLevel.Unsafe;

namespace FastPoints.Benchmarks
{
    /// <summary>
    /// A pass over a file by plain threads and plain reads, without jobs, containers or any of the package: what the reader is
    /// held against. As many threads as the job system has, each taking the next stretch.
    /// </summary>
    static unsafe class PlyPlainPass
    {
        const int StretchPoints = 65536;

        /// <summary>Columns, one point after the other; or, without, the bytes copied as they are.</summary>
        public static WorkloadResult Run(string path, bool isDecoding)
        {
            long bytes = new FileInfo(path).Length;
            long next = -1, points = 0;
            var threads = new Thread[JobsUtility.JobWorkerCount + 1];
            for (int i = 0; i < threads.Length; i++)
            {
                threads[i] = new Thread(() =>
                {
                    const int Stretch = StretchPoints * PlyBenchmarkFile.RecordBytes;
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
                            if (isDecoding)
                                Decode(source, target, count / PlyBenchmarkFile.RecordBytes);
                            else
                                Buffer.MemoryCopy(source, target, Stretch, count);
                            Interlocked.Add(ref points, count / PlyBenchmarkFile.RecordBytes);
                        }
                    }
                    Marshal.FreeHGlobal((IntPtr)source);
                    Marshal.FreeHGlobal((IntPtr)target);
                });
                threads[i].Start();
            }
            foreach (var thread in threads)
                thread.Join();
            return new WorkloadResult { Points = points, Bytes = bytes };
        }

        static void Decode(byte* source, byte* target, int points)
        {
            var x = (uint*)target;
            var y = (uint*)(target + 4 * StretchPoints);
            var z = (uint*)(target + 8 * StretchPoints);
            byte* red = target + 12 * StretchPoints, green = target + 13 * StretchPoints, blue = target + 14 * StretchPoints;
            for (int i = 0; i < points; i++, source += PlyBenchmarkFile.RecordBytes)
            {
                x[i] = *(uint*)source;
                y[i] = *(uint*)(source + 4);
                z[i] = *(uint*)(source + 8);
                red[i] = source[12];
                green[i] = source[13];
                blue[i] = source[14];
            }
        }
    }
}
