using System;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints
{
    /// <summary>Up to Capacity points as columns in one piece of native memory, which the caller owns and readers fill. One
    /// allocation is one safety handle: a job that writes several columns takes <see cref="Bytes"/> whole.</summary>
    public sealed class PointBatch : IDisposable
    {
        const int ColumnAlignmentBytes = 64;

        readonly PointColumn[] m_columns;
        NativeArray<byte> m_bytes;

        public PointBatch(PointSchema schema, int capacity, Allocator allocator)
        {
            Schema = schema;
            Capacity = capacity;
            m_columns = new PointColumn[schema.Count];
            long end = 0;
            for (int i = 0; i < m_columns.Length; i++)
            {
                m_columns[i] = new PointColumn { OffsetBytes = (int)Math.Min(end, int.MaxValue), Type = schema[i].Type };
                long width = (long)capacity * schema[i].Type.SizeOf();
                end += (width + ColumnAlignmentBytes - 1) / ColumnAlignmentBytes * ColumnAlignmentBytes;
            }
            if (end > int.MaxValue)
                throw new ArgumentOutOfRangeException(nameof(capacity), capacity, "a batch holds at most 2 GiB");
            m_bytes = new NativeArray<byte>((int)Math.Max(end, 1), allocator, NativeArrayOptions.UninitializedMemory);
        }

        public PointSchema Schema { get; }
        public int Capacity { get; }

        /// <summary>Number of valid points from the start of each column. The code that fills the batch sets it.</summary>
        public int Count { get; set; }

        public bool IsCreated => m_bytes.IsCreated;

        /// <summary>All columns; see <see cref="Column(int)"/> for where each one lies.</summary>
        public NativeArray<byte> Bytes => m_bytes;

        public PointColumn Column(int index) => m_columns[index];

        /// <summary>A view of one whole column (<see cref="Capacity"/> values). T must have the attribute's size.</summary>
        public NativeArray<T> Column<T>(int index) where T : unmanaged
        {
            int size = m_columns[index].Type.SizeOf();
            return m_bytes.GetSubArray(m_columns[index].OffsetBytes, Capacity * size).Reinterpret<T>(1);
        }

        /// <summary>The same by name.</summary>
        public NativeArray<T> Column<T>(string name) where T : unmanaged => Column<T>(Schema.IndexOf(name));

        public void Dispose()
        {
            if (m_bytes.IsCreated)
                m_bytes.Dispose();
        }

        public JobHandle Dispose(JobHandle inputDeps) => m_bytes.IsCreated ? m_bytes.Dispose(inputDeps) : inputDeps;
    }

    /// <summary>Where one attribute's values lie in a batch's memory. Blittable: jobs carry arrays of these.</summary>
    public struct PointColumn
    {
        /// <summary>Byte offset of the first value; a multiple of 64.</summary>
        public int OffsetBytes;

        public AttributeType Type;

        internal readonly unsafe byte* At(byte* batch, int point) => batch + OffsetBytes + (long)point * Type.SizeOf();
    }
}
