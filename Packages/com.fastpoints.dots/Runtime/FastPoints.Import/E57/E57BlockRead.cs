using System;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.E57
{
    // The last step of a range; it also removes the points that are left out from all columns.
    [BurstCompile]
    unsafe struct TransformE57PointsJob : IJob
    {
        public NativeArray<double> Vectors;
        public int RowLength;
        [ReadOnly] public NativeArray<byte> Rejections;
        [ReadOnly] public NativeArray<byte> IsDamaged;
        [ReadOnly] public NativeArray<E57Extent> Extents;
        public int ExtentCount;
        [ReadOnly] public NativeArray<PointColumn> ColumnTable;
        public NativeArray<byte> Columns;
        public NativeReference<DecodeResult> Result;
        public NativeReference<E57Anomalies> Anomalies;

        // In rows 0 to 2 and rows 3 to 5.
        public bool HasPositions;
        public bool IsSpherical;
        public bool HasNormals;
        public E57Pose Pose;

        // -1 for unwanted ones.
        public int3 PositionColumns;
        public int3 NormalColumns;

        public void Execute()
        {
            var result = Result.Value;
            if (HasPositions)
            {
                if (IsSpherical)
                    FromSpherical(result.Points);
                Rotate(0, result.Points, Pose.Translation, PositionColumns);
            }
            if (HasNormals)
                Rotate(3, result.Points, new double3(0, 0, 0), NormalColumns);
            Compact(ref result);
            Result.Value = result;
        }

        double* Row(int row) => (double*)Vectors.GetUnsafePtr() + (long)row * RowLength;

        // ASTM E2807, 8.4.3: azimuth from x to y, elevation from the xy plane, in radians.
        void FromSpherical(int count)
        {
            double* row0 = Row(0), row1 = Row(1), row2 = Row(2);
            for (int i = 0; i < count; i++)
            {
                double range = row0[i];
                math.sincos(row1[i], out double sinAzimuth, out double cosAzimuth);
                math.sincos(row2[i], out double sinElevation, out double cosElevation);
                row0[i] = range * cosElevation * cosAzimuth;
                row1[i] = range * cosElevation * sinAzimuth;
                row2[i] = range * sinElevation;
            }
        }

        void Rotate(int row, int count, double3 shift, int3 columns)
        {
            double* row0 = Row(row), row1 = Row(row + 1), row2 = Row(row + 2);
            if (!Pose.IsTranslation)
            {
                double3 x = Pose.AxisX, y = Pose.AxisY, z = Pose.AxisZ;
                for (int i = 0; i < count; i++)
                {
                    double3 turned = x * row0[i] + y * row1[i] + z * row2[i] + shift;
                    row0[i] = turned.x;
                    row1[i] = turned.y;
                    row2[i] = turned.z;
                }
            }
            else if (!math.all(shift == new double3(0, 0, 0)))
            {
                for (int i = 0; i < count; i++)
                {
                    row0[i] += shift.x;
                    row1[i] += shift.y;
                    row2[i] += shift.z;
                }
            }
            Store(row0, columns.x, count);
            Store(row1, columns.y, count);
            Store(row2, columns.z, count);
        }

        void Store(double* values, int column, int count)
        {
            if (column < 0)
                return;
            byte* to = (byte*)Columns.GetUnsafePtr() + ColumnTable[column].OffsetBytes;
            if (ColumnTable[column].Type == AttributeType.Float32)
                for (int i = 0; i < count; i++)
                    ((float*)to)[i] = (float)values[i];
            else
                UnsafeUtility.MemCpy(to, values, (long)count * 8);
        }

        void Compact(ref DecodeResult result)
        {
            byte* rejections = (byte*)Rejections.GetUnsafeReadOnlyPtr();
            var anomalies = Anomalies.Value;
            for (int i = 0; i < result.Points; i++)
            {
                anomalies.Invalid += rejections[i] == E57Rejection.Invalid ? 1 : 0;
                anomalies.Damaged += rejections[i] == E57Rejection.Damaged ? 1 : 0;
            }
            if (anomalies.Damaged > 0)
                CountPages(ref anomalies);
            Anomalies.Value = anomalies;
            if (anomalies.Invalid + anomalies.Damaged == 0)
                return;
            byte* columns = (byte*)Columns.GetUnsafePtr();
            for (int first = 0, kept = 0; first < result.Points;)
            {
                int end = first;
                while (end < result.Points && rejections[end] == 0)
                    end++;
                if (kept < first && end > first)
                    for (int c = 0; c < ColumnTable.Length; c++)
                        Move(columns + ColumnTable[c].OffsetBytes, ColumnTable[c].Type.SizeOf(), first, kept, end - first);
                kept += end - first;
                first = end;
                while (first < result.Points && rejections[first] != 0)
                    first++;
            }
            result.Points -= anomalies.Invalid + anomalies.Damaged;
        }

        static void Move(byte* column, int bytes, long from, long to, long count) =>
            UnsafeUtility.MemMove(column + to * bytes, column + from * bytes, count * bytes);

        void CountPages(ref E57Anomalies anomalies)
        {
            for (int e = 0; e < ExtentCount; e++)
                for (int page = 0; page < Extents[e].Pages; page++)
                {
                    if (IsDamaged[Extents[e].BufferPage + page] == 0)
                        continue;
                    if (anomalies.DamagedPages == 0)
                        anomalies.FirstDamagedPage = Extents[e].FirstPage + page;
                    anomalies.DamagedPages++;
                }
        }
    }

    sealed class E57BlockRead : OwningBlockRead
    {
        const int VectorRows = 6;

        readonly E57Blocks m_blocks;
        readonly E57PagesRead m_pages;
        readonly bool[] m_isWanted = new bool[E57Scan.MaxFields];
        readonly long[] m_firstPages = new long[E57Scan.MaxFields];
        readonly long[] m_endPages = new long[E57Scan.MaxFields];
        readonly NativeArray<PointColumn> m_columns;
        readonly NativeArray<double> m_vectors;
        readonly NativeArray<byte> m_rejections;
        readonly NativeArray<byte> m_scratch;
        readonly NativeReference<E57Anomalies> m_anomalies;
        NativeArray<E57FieldRead> m_reads;
        NativeArray<E57StreamRange> m_ranges;
        int m_readCount;
        E57Section m_section;
        TransformE57PointsJob m_transform;

        public E57BlockRead(PointReader reader, E57Blocks blocks, PointSchema wanted, int capacity, Allocator allocator)
            : base(reader, wanted, capacity, allocator)
        {
            m_blocks = blocks;
            m_pages = Own(new E57PagesRead(blocks.File, blocks.MaxPages, E57Scan.MaxFields, allocator));
            // Wanted columns, invalid states, and rows that no column is made of.
            int reads = wanted.Count + VectorRows + 1;
            m_reads = OwnArray<E57FieldRead>(reads, allocator, NativeArrayOptions.ClearMemory);
            m_ranges = OwnArray<E57StreamRange>(reads, allocator, NativeArrayOptions.ClearMemory);
            var columns = new PointColumn[wanted.Count];
            for (int i = 0; i < columns.Length; i++)
                columns[i] = Points.Column(i);
            m_columns = Own(new NativeArray<PointColumn>(columns, allocator));
            m_vectors = OwnArray<double>(blocks.HasVectors ? VectorRows * capacity : 1, allocator);
            m_rejections = OwnArray<byte>(Math.Max(1, capacity), allocator);
            m_scratch = OwnArray<byte>(8 * (capacity + 1) + E57Bits.PaddingBytes, allocator, NativeArrayOptions.ClearMemory);
            m_anomalies = Own(new NativeReference<E57Anomalies>(allocator));
        }

        protected override JobHandle Schedule(BlockRange range)
        {
            m_pages.Clear();
            m_pages.Fetched = TakeFetched();
            var section = m_blocks.SectionOf(range.Block);
            if (section != m_section)
                PlanSection(section);
            long first = (long)(range.Block - section.FirstBlock) * section.BlockPoints + range.First;
            return Schedule(first, range.Count);
        }

        void PlanSection(E57Section section)
        {
            m_section = section;
            var reads = m_blocks.Schema.ReadsOf(section.Index, Points);
            m_readCount = reads.Count;
            Array.Clear(m_isWanted, 0, m_isWanted.Length);
            bool hasPositions = false, hasNormals = false;
            for (int i = 0; i < reads.Count; i++)
            {
                m_reads[i] = reads[i];
                if (reads[i].Stream >= 0)
                    m_isWanted[reads[i].Stream] = true;
                hasPositions |= reads[i].Target == E57Target.Vector && reads[i].Row < 3;
                hasNormals |= reads[i].Target == E57Target.Vector && reads[i].Row >= 3;
            }
            var schema = Points.Schema;
            m_transform = new TransformE57PointsJob
            {
                Vectors = m_vectors,
                RowLength = Points.Capacity,
                Rejections = m_rejections,
                IsDamaged = m_pages.IsDamaged,
                Extents = m_pages.Extents,
                ColumnTable = m_columns,
                Columns = Points.Bytes,
                Result = Result,
                Anomalies = m_anomalies,
                HasPositions = hasPositions,
                IsSpherical = !section.Scan.IsCartesian,
                HasNormals = hasNormals,
                Pose = section.Scan.Pose,
                PositionColumns = new int3(schema.IndexOf(AttributeNames.X), schema.IndexOf(AttributeNames.Y),
                    schema.IndexOf(AttributeNames.Z)),
                NormalColumns = new int3(schema.IndexOf(AttributeNames.NormalX), schema.IndexOf(AttributeNames.NormalY),
                    schema.IndexOf(AttributeNames.NormalZ)),
            };
        }

        JobHandle Schedule(long first, int count)
        {
            int rangeCount = m_section.PagesOf(first, first + count, m_isWanted, m_firstPages, m_endPages);
            for (int i = 0; i < rangeCount; i++)
                m_pages.Add(m_firstPages[i], (int)(m_endPages[i] - m_firstPages[i]));
            for (int i = 0; i < m_readCount; i++)
            {
                if (m_reads[i].Stream < 0 || m_reads[i].Bits == 0)
                    continue;
                var checkpoint = m_section.CheckpointOf(m_reads[i].Stream, first);
                m_ranges[i] = new E57StreamRange
                {
                    PacketOffset = checkpoint.PacketOffset,
                    BytesBefore = checkpoint.BytesBefore,
                    End = m_section.EndOf(m_reads[i].Stream, first + count),
                };
            }
            var decode = new DecodeE57Job
            {
                Input = m_pages.Buffer,
                IsDamaged = m_pages.IsDamaged,
                Extents = m_pages.Extents,
                ExtentCount = m_pages.ExtentCount,
                StreamCount = m_section.Scan.Fields.Count,
                Reads = m_reads,
                Ranges = m_ranges,
                FirstRecord = first,
                Count = count,
                Columns = Points.Bytes,
                Vectors = m_vectors,
                RowLength = Points.Capacity,
                Rejections = m_rejections,
                Scratch = m_scratch,
                Result = Result,
                Anomalies = m_anomalies,
            };
            var done = DependencyOf(m_pages.Begin());
            for (int i = 0; i == 0 || i < m_readCount; i += DecodeE57Job.FieldsPerSlice)
            {
                decode.FirstRead = i;
                decode.ReadCount = Math.Min(DecodeE57Job.FieldsPerSlice, m_readCount - i);
                done = decode.Schedule(done);
            }
            m_transform.ExtentCount = m_pages.ExtentCount;
            return m_transform.Schedule(done);
        }

        protected override void EndRead() => m_pages.End();

        protected override void Warn(DecodeResult result) => m_blocks.Warn(Range, result, m_anomalies.Value);
    }
}
