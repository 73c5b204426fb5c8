using System;
using System.Runtime.InteropServices;
using FastPoints.Las;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Benchmarks
{
    public struct LasDecodeWorkload : IWorkload
    {
        const int Blocks = 128;

        NativeArray<byte> m_records;
        NativeArray<FieldCopy> m_copies;
        NativeReference<DecodeResult> m_result;
        PointBatch m_batch;

        public string Name => "las decode";
        public string LimitName => "las decode by pointers";

        public void Prepare(WorkloadContext context)
        {
            var layout = new LasRecordLayout(LasPointFormat.Of(LasBenchmarkFile.PointFormat), LasBenchmarkFile.RecordBytes,
                Array.Empty<PointField>());
            m_batch = new PointBatch(LasBenchmarkFile.Wanted(layout.Schema), LasBenchmarkFile.BlockPoints, Allocator.Persistent);
            m_copies = new NativeArray<FieldCopy>(FieldCopyPlan.Make(layout.Fields, m_batch), Allocator.Persistent);
            m_records = new NativeArray<byte>(LasBenchmarkFile.BlockPoints * LasBenchmarkFile.RecordBytes, Allocator.Persistent);
            m_result = new NativeReference<DecodeResult>(Allocator.Persistent);
            Run();
        }

        public WorkloadResult Run()
        {
            for (int i = 0; i < Blocks; i++)
                new DecodeRecordsJob
                {
                    Records = m_records,
                    Copies = m_copies,
                    Columns = m_batch.Bytes,
                    Result = m_result,
                    RecordBytes = LasBenchmarkFile.RecordBytes,
                    Count = LasBenchmarkFile.BlockPoints,
                }.Run();
            return new WorkloadResult
            {
                Points = (long)Blocks * LasBenchmarkFile.BlockPoints,
                Bytes = (long)Blocks * m_records.Length,
            };
        }

        public void Dispose()
        {
            if (!m_records.IsCreated)
                return;
            m_batch.Dispose();
            m_copies.Dispose();
            m_records.Dispose();
            m_result.Dispose();
        }
    }

    public unsafe struct LasDecodePointersWorkload : IWorkload
    {
        const int Blocks = 128;
        const int Points = LasBenchmarkFile.BlockPoints;

        byte* m_records;
        byte* m_columns;

        public string Name => "las decode by pointers";
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            m_records = (byte*)Marshal.AllocHGlobal(Points * LasBenchmarkFile.RecordBytes);
            m_columns = (byte*)Marshal.AllocHGlobal(Points * 18);
            new Span<byte>(m_records, Points * LasBenchmarkFile.RecordBytes).Clear();
            Run();
        }

        public WorkloadResult Run()
        {
            for (int i = 0; i < Blocks; i++)
                Decode(m_records, (int*)m_columns, (ushort*)(m_columns + 12 * Points));
            return new WorkloadResult
            {
                Points = (long)Blocks * Points,
                Bytes = (long)Blocks * Points * LasBenchmarkFile.RecordBytes,
            };
        }

        public void Dispose()
        {
            Marshal.FreeHGlobal((IntPtr)m_records);
            Marshal.FreeHGlobal((IntPtr)m_columns);
            m_records = null;
            m_columns = null;
        }

        static void Decode(byte* record, int* positions, ushort* colors)
        {
            int* x = positions, y = positions + Points, z = positions + 2 * Points;
            ushort* red = colors, green = colors + Points, blue = colors + 2 * Points;
            for (int i = 0; i < Points; i++, record += LasBenchmarkFile.RecordBytes)
            {
                x[i] = ((int*)record)[0];
                y[i] = ((int*)record)[1];
                z[i] = ((int*)record)[2];
                red[i] = *(ushort*)(record + LasBenchmarkFile.ColorByte);
                green[i] = *(ushort*)(record + LasBenchmarkFile.ColorByte + 2);
                blue[i] = *(ushort*)(record + LasBenchmarkFile.ColorByte + 4);
            }
        }
    }
}
