using FastPoints.Core;
using FastPoints.Store;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Nodes
{
    /// <summary>The averaged columns, at most four, and the averages of a chunk's points. Blittable, for jobs.</summary>
    internal unsafe struct AveragedColumns
    {
        /// <summary>Empty if nothing is averaged.</summary>
        [ReadOnly] public NativeArray<StoredColumn> Columns;

        /// <summary>For each point, its index in <see cref="Averages"/>; -1 for a point that represents what its record says, or
        /// only itself. Empty if nothing is averaged.</summary>
        public NativeArray<int> AverageOfPoint;
        public NativeList<PointAverage> Averages;

        public bool IsOn => Columns.Length > 0;

        /// <summary>The points that a point represents so far.</summary>
        public PointAverage Of(int point, byte* record, RecordLayout layout)
        {
            int average = AverageOfPoint[point];
            if (average >= 0)
                return Averages[average];
            var attributes = layout.AttributesOf(record);
            var own = new PointAverage { Points = 1 };
            if (layout.AverageBytes > 0)
            {
                // Records are only aligned to whole words.
                UnsafeUtility.MemCpy(&own, attributes + layout.AttributeBytes, sizeof(PointAverage));
                return own;
            }
            for (int c = 0; c < Columns.Length; c++)
                own.Sum[c] = Load(attributes + Columns[c].RecordOffset, Columns[c].Type);
            return own;
        }

        /// <summary>A point's averaged value of one column, in packed form.</summary>
        public ulong Stored(in PointAverage average, int column)
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
