using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Scenes
{
    /// <summary>Copies some returns, in a given order or as they come, into the columns of a batch.</summary>
    [BurstCompile]
    internal unsafe struct ReturnsToColumnsJob : IJob
    {
        /// <summary>The attributes of LAS point format 7 that a scan fills.</summary>
        public static PointSchema Schema => new PointSchema(new[]
        {
            new PointAttribute(AttributeNames.X, AttributeType.Int32),
            new PointAttribute(AttributeNames.Y, AttributeType.Int32),
            new PointAttribute(AttributeNames.Z, AttributeType.Int32),
            new PointAttribute(AttributeNames.Intensity, AttributeType.UInt16),
            new PointAttribute(AttributeNames.ReturnNumber, AttributeType.UInt8),
            new PointAttribute(AttributeNames.NumberOfReturns, AttributeType.UInt8),
            new PointAttribute(AttributeNames.Classification, AttributeType.UInt8),
            new PointAttribute(AttributeNames.ScanAngle, AttributeType.Int16),
            new PointAttribute(AttributeNames.PointSourceId, AttributeType.UInt16),
            new PointAttribute(AttributeNames.GpsTime, AttributeType.Float64),
            new PointAttribute(AttributeNames.Red, AttributeType.UInt16),
            new PointAttribute(AttributeNames.Green, AttributeType.UInt16),
            new PointAttribute(AttributeNames.Blue, AttributeType.UInt16),
        });

        [ReadOnly] public NativeArray<ScanReturn> Returns;

        /// <summary>Index of the return at each place if <see cref="HasOrder"/>; otherwise any created array.</summary>
        [ReadOnly] public NativeArray<int> ReturnOfIndex;

        public bool HasOrder;
        public int FirstIndex;
        public int Count;
        public NativeArray<byte> Bytes; // Memory of a batch of Schema, and the location of each of its columns.

        [ReadOnly] public NativeArray<PointColumn> Columns;

        public void Execute()
        {
            byte* bytes = (byte*)Bytes.GetUnsafePtr();
            var x = (int*)(bytes + Columns[0].OffsetBytes);
            var y = (int*)(bytes + Columns[1].OffsetBytes);
            var z = (int*)(bytes + Columns[2].OffsetBytes);
            var intensity = (ushort*)(bytes + Columns[3].OffsetBytes);
            var returnNumber = bytes + Columns[4].OffsetBytes;
            var numberOfReturns = bytes + Columns[5].OffsetBytes;
            var classification = bytes + Columns[6].OffsetBytes;
            var scanAngle = (short*)(bytes + Columns[7].OffsetBytes);
            var station = (ushort*)(bytes + Columns[8].OffsetBytes);
            var time = (double*)(bytes + Columns[9].OffsetBytes);
            var red = (ushort*)(bytes + Columns[10].OffsetBytes);
            var green = (ushort*)(bytes + Columns[11].OffsetBytes);
            var blue = (ushort*)(bytes + Columns[12].OffsetBytes);
            for (int i = 0; i < Count; i++)
            {
                int index = FirstIndex + i;
                var r = Returns[HasOrder ? ReturnOfIndex[index] : index];
                x[i] = r.X;
                y[i] = r.Y;
                z[i] = r.Z;
                intensity[i] = r.Intensity;
                returnNumber[i] = r.ReturnNumber;
                numberOfReturns[i] = r.NumberOfReturns;
                classification[i] = r.Classification;
                scanAngle[i] = r.ScanAngle;
                station[i] = r.Station;
                time[i] = r.GpsTime;
                red[i] = r.Red;
                green[i] = r.Green;
                blue[i] = r.Blue;
            }
        }
    }
}
