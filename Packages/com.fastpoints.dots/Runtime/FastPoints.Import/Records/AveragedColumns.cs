using FastPoints.Points;
using FastPoints.Store;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Records
{
    /// <summary>The columns that are averaged, at most four, and the averages of a chunk's points. Blittable, for jobs.</summary>
    internal unsafe struct AveragedColumns
    {
        /// <summary>None where nothing is averaged.</summary>
        [ReadOnly] public NativeArray<StoredColumn> Columns;

        /// <summary>By point: its average among <see cref="Averages"/>; -1 for a point that stands for what its record says, or
        /// for itself alone. Empty where nothing is averaged.</summary>
        public NativeArray<int> AverageOfPoint;
        public NativeList<PointAverage> Averages;

        public bool IsOn => Columns.Length > 0;

        /// <summary>What a point stands for, so far.</summary>
        public PointAverage Of(int point, byte* record, RecordLayout layout)
        {
            int average = AverageOfPoint[point];
            if (average >= 0)
                return Averages[average];
            var attributes = layout.AttributesOf(record);
            var own = new PointAverage { Points = 1 };
            if (layout.AverageBytes > 0)
            {
                // Records lie on whole words only.
                UnsafeUtility.MemCpy(&own, attributes + layout.AttributeBytes, sizeof(PointAverage));
                return own;
            }
            for (int c = 0; c < Columns.Length; c++)
                own.Sum[c] = Load(attributes + Columns[c].RecordOffset, Columns[c].Type);
            return own;
        }

        /// <summary>A point's averaged value of one column, as it is packed.</summary>
        public ulong Stored(in PointAverage average, int column)
        {
            double mean = average.Sum[column] / average.Points;
            if (Columns[column].Type != AttributeType.Float32)
                return (ulong)(mean / Columns[column].Divisor + 0.5);
            float single = (float)mean;
            return OrderedBits.Load((byte*)&single, AttributeType.Float32);
        }

        static double Load(byte* value, AttributeType type)
        {
            switch (type)
            {
                case AttributeType.UInt8: return *value;
                case AttributeType.UInt16: return *(ushort*)value;
                default: return *(float*)value;
            }
        }
    }

    /// <summary>What a sampled point stands for. Blittable.</summary>
    internal struct PointAverage
    {
        /// <summary>Points of the cloud, itself included.</summary>
        public double Points;

        /// <summary>Sums over them of up to four values: the columns of the averaged planes.</summary>
        public double4 Sum;
    }
}
