using System;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs.LowLevel.Unsafe;

namespace FastPoints.Benchmarks
{
    /// <summary>The minimum that any octree build must do, without checks, samples, packing, or care for memory: read and count,
    /// read and scatter, order each cell along the Morton curve, write 12 bytes a point.</summary>
    public unsafe struct BarePassWorkload : IWorkload
    {
        const int PiecePoints = 32768, StrideBytes = 16, CellsLog2 = 3;

        string m_source, m_target;

        public string Name => "convert bare pass";
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            m_source = TerrainBenchmarkFile.Make(context);
            m_target = Path.Combine(context.ScratchFolder, "bare.bin");
            Run();
        }

        public WorkloadResult Run()
        {
            var pass = new Pass(m_source);
            pass.Run(m_target);
            return new WorkloadResult { Points = pass.Points, Bytes = new FileInfo(m_source).Length };
        }

        public void Dispose() => File.Delete(m_target);

        sealed class Pass
        {
            readonly string m_path;
            readonly int m_dataOffset, m_shift;
            readonly long[] m_next = new long[1 << (2 * CellsLog2)];
            byte* m_records;

            public int Points { get; }

            public Pass(string path)
            {
                m_path = path;
                byte[] header;
                using (var file = new BinaryReader(File.OpenRead(path)))
                    header = file.ReadBytes(227);
                m_dataOffset = BitConverter.ToInt32(header, 96);
                Points = BitConverter.ToInt32(header, 107);
                double extent = Math.Max(BitConverter.ToDouble(header, 179) - BitConverter.ToDouble(header, 187),
                    BitConverter.ToDouble(header, 195) - BitConverter.ToDouble(header, 203)) / BitConverter.ToDouble(header, 131);
                while ((long)extent >> m_shift >= 1 << CellsLog2)
                    m_shift++;
            }

            public void Run(string target)
            {
                m_records = (byte*)UnsafeUtility.Malloc((long)Points * StrideBytes, 64, Allocator.Persistent);
                var threads = new ParallelOptions { MaxDegreeOfParallelism = JobsUtility.JobWorkerCount + 1 };
                int pieces = (Points + PiecePoints - 1) / PiecePoints;
                Parallel.For(0, pieces, threads, () => new Piece(m_path),
                    (piece, _, buffer) => { Count(piece, buffer); return buffer; }, b => b.Dispose());
                var first = new long[m_next.Length + 1];
                for (int c = 0; c < m_next.Length; c++)
                {
                    first[c + 1] = first[c] + m_next[c];
                    m_next[c] = first[c];
                }
                Parallel.For(0, pieces, threads, () => new Piece(m_path),
                    (piece, _, buffer) => { Scatter(piece, buffer); return buffer; }, b => b.Dispose());
                using (var file = new FileStream(target, FileMode.Create))
                    Parallel.For(0, m_next.Length, threads,
                        cell => OrderAndWrite(first[cell], (int)(first[cell + 1] - first[cell]), file));
                UnsafeUtility.Free(m_records, Allocator.Persistent);
            }

            int CellOf(byte* record) => ((int*)record)[0] >> m_shift | ((int*)record)[1] >> m_shift << CellsLog2;

            int Read(int piece, Piece buffer)
            {
                int count = Math.Min(PiecePoints, Points - piece * PiecePoints);
                buffer.File.Position = m_dataOffset + (long)piece * PiecePoints * TerrainBenchmarkFile.RecordBytes;
                for (int got = 0, wanted = count * TerrainBenchmarkFile.RecordBytes; got < wanted;)
                    got += buffer.File.Read(buffer.Bytes, got, wanted - got);
                return count;
            }

            void Count(int piece, Piece buffer)
            {
                int count = Read(piece, buffer);
                var counts = stackalloc int[1 << (2 * CellsLog2)];
                fixed (byte* start = buffer.Bytes)
                    for (int i = 0; i < count; i++)
                        counts[CellOf(start + i * TerrainBenchmarkFile.RecordBytes)]++;
                for (int c = 0; c < m_next.Length; c++)
                    Interlocked.Add(ref m_next[c], counts[c]);
            }

            void Scatter(int piece, Piece buffer)
            {
                int count = Read(piece, buffer);
                var counts = stackalloc int[1 << (2 * CellsLog2)];
                var next = stackalloc long[1 << (2 * CellsLog2)];
                fixed (byte* start = buffer.Bytes)
                {
                    for (int i = 0; i < count; i++)
                        counts[CellOf(start + i * TerrainBenchmarkFile.RecordBytes)]++;
                    for (int c = 0; c < m_next.Length; c++)
                        next[c] = Interlocked.Add(ref m_next[c], counts[c]) - counts[c];
                    for (int i = 0; i < count; i++)
                    {
                        byte* from = start + i * TerrainBenchmarkFile.RecordBytes;
                        byte* to = m_records + next[CellOf(from)]++ * StrideBytes;
                        *(long*)to = *(long*)from;
                        ((int*)to)[2] = ((int*)from)[2];
                        to[12] = from[21];
                        to[13] = from[23];
                        to[14] = from[25];
                    }
                }
            }

            void OrderAndWrite(long first, int count, FileStream file)
            {
                if (count == 0)
                    return;
                var keys = (ulong*)UnsafeUtility.Malloc(2L * count * sizeof(ulong), 64, Allocator.Persistent);
                var order = (uint*)UnsafeUtility.Malloc(2L * count * sizeof(uint), 64, Allocator.Persistent);
                var bytes = new byte[count * 12];
                byte* records = m_records + first * StrideBytes;
                for (int i = 0; i < count; i++)
                {
                    var position = (int*)(records + (long)i * StrideBytes);
                    keys[i] = Morton.Encode((uint)position[0], (uint)position[1], (uint)(position[2] + (1 << 20)));
                    order[i] = (uint)i;
                }
                RadixSort.Sort(keys, order, keys + count, order + count, count);
                fixed (byte* to = bytes)
                    for (int i = 0; i < count; i++)
                    {
                        byte* from = records + (long)order[i] * StrideBytes;
                        *(long*)(to + i * 12) = *(long*)from;
                        *(int*)(to + i * 12 + 8) = *(int*)(from + 12);
                    }
                UnsafeUtility.Free(order, Allocator.Persistent);
                UnsafeUtility.Free(keys, Allocator.Persistent);
                lock (file)
                    file.Write(bytes, 0, bytes.Length);
            }
        }

        sealed class Piece : IDisposable
        {
            public readonly FileStream File;
            public readonly byte[] Bytes = new byte[PiecePoints * TerrainBenchmarkFile.RecordBytes];

            public Piece(string path) => File = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.Read, 1);

            public void Dispose() => File.Dispose();
        }
    }
}
