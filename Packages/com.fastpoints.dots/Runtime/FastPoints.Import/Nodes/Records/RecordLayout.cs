using System.Runtime.CompilerServices;
using FastPoints.Store;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Nodes
{
    /// <summary>
    /// The memory layout of a point while the octree is built: one record, so that scattering and gathering touch one address.
    /// <code>
    /// narrow: x, y, z as 32-bit offsets from Base | attributes, padded to whole words
    /// wide:   x, y, z as 64-bit grid numbers      | attributes, padded to whole words
    /// </code>
    /// Blittable, for jobs.
    /// </summary>
    internal unsafe struct RecordLayout
    {
        public bool IsWide;
        public Grid3 Base; // The corner that narrow positions count from; zero if wide.
        public int AttributeBytes; // Padded to whole 32-bit words.

        /// <summary>Bytes of an <see cref="AverageSums"/> after the attributes, or 0: the tops of chunks have it if colours are
        /// averaged. It is not part of the point.</summary>
        public int AverageBytes;

        public RecordLayout(bool isWide, Grid3 origin, int attributeBytes)
        {
            IsWide = isWide;
            Base = isWide ? default : origin;
            AttributeBytes = RecordHash.PaddedBytes(attributeBytes);
            AverageBytes = 0;
        }

        public int PositionBytes => IsWide ? 24 : 12;
        public int StrideBytes => PositionBytes + AttributeBytes + AverageBytes;

        public RecordLayout ForTops(bool hasAverages)
        {
            var result = this;
            result.AverageBytes = hasAverages ? sizeof(AverageSums) : 0;
            return result;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Grid3 PositionOf(byte* record)
        {
            if (IsWide)
                return new Grid3(((long*)record)[0], ((long*)record)[1], ((long*)record)[2]);
            var p = (uint*)record;
            return new Grid3(Base.X + p[0], Base.Y + p[1], Base.Z + p[2]);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void SetPosition(byte* record, long x, long y, long z)
        {
            if (IsWide)
            {
                ((long*)record)[0] = x;
                ((long*)record)[1] = y;
                ((long*)record)[2] = z;
                return;
            }
            ((uint*)record)[0] = (uint)(x - Base.X);
            ((uint*)record)[1] = (uint)(y - Base.Y);
            ((uint*)record)[2] = (uint)(z - Base.Z);
        }

        public void LoadNarrowPositions(byte* records, int count, uint* x, uint* y, uint* z)
        {
            int stride = StrideBytes;
            for (int i = 0; i < count; i++, records += stride)
            {
                x[i] = ((uint*)records)[0];
                y[i] = ((uint*)records)[1];
                z[i] = ((uint*)records)[2];
            }
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public byte* AttributesOf(byte* record) => record + PositionBytes;

        /// <summary>Copies one record: its words, as most have few.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void Copy(byte* from, byte* to, int strideBytes)
        {
            int at = 0;
            for (; at + sizeof(ulong) <= strideBytes; at += sizeof(ulong))
                *(ulong*)(to + at) = *(ulong*)(from + at);
            if (at < strideBytes)
                *(uint*)(to + at) = *(uint*)(from + at);
        }

        public ulong HashOf(byte* record, ulong seed) =>
            RecordHash.Of(PositionOf(record), AttributesOf(record), AttributeBytes, seed);
    }

    internal struct AverageSums
    {
        public double Points; // Number of points of the cloud, including itself.
        public double4 Sum; // Sums over them of up to four values: the columns of the averaged planes.
    }

    /// <summary>The averaged columns, at most four, and the averages of a chunk's points. Blittable, for jobs.</summary>
    internal unsafe struct AveragedColumns
    {
        [ReadOnly] public NativeArray<StoredColumn> Columns; // Empty if nothing is averaged.

        /// <summary>For each point, its index in <see cref="Sums"/>; -1 for a point that represents what its record says, or
        /// only itself. Empty if nothing is averaged.</summary>
        public NativeArray<int> AverageOfPoint;
        public NativeList<AverageSums> Sums;

        public bool HasColumns => Columns.Length > 0;

        public AverageSums Of(int point, byte* record, RecordLayout layout)
        {
            int average = AverageOfPoint[point];
            if (average >= 0)
                return Sums[average];
            var attributes = layout.AttributesOf(record);
            var own = new AverageSums { Points = 1 };
            if (layout.AverageBytes > 0)
            {
                // Records are only aligned to whole words.
                UnsafeUtility.MemCpy(&own, attributes + layout.AttributeBytes, sizeof(AverageSums));
                return own;
            }
            for (int c = 0; c < Columns.Length; c++)
                own.Sum[c] = Load(attributes + Columns[c].RecordOffset, Columns[c].Type);
            return own;
        }

        public ulong Stored(in AverageSums average, int column)
        {
            double mean = average.Sum[column] / average.Points;
            if (Columns[column].Type != AttributeType.Float32)
                return (ulong)(mean / Columns[column].Divisor + 0.5);
            float single = (float)mean;
            return OrderedBits.Load((byte*)&single, AttributeType.Float32);
        }

        static double Load(byte* value, AttributeType type) => type switch
        {
            AttributeType.UInt8 => *value,
            AttributeType.UInt16 => *(ushort*)value,
            _ => *(float*)value,
        };
    }
}
