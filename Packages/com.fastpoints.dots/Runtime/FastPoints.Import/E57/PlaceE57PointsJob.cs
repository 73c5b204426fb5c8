using FastPoints.Core;
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
    unsafe struct PlaceE57PointsJob : IJob
    {
        public NativeArray<double> Vectors;
        public int RowLength;
        [ReadOnly] public NativeArray<byte> Drops;
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
            if (!Pose.IsShift)
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
            byte* drops = (byte*)Drops.GetUnsafeReadOnlyPtr();
            var anomalies = Anomalies.Value;
            for (int i = 0; i < result.Points; i++)
            {
                anomalies.Invalid += drops[i] == E57Drop.Invalid ? 1 : 0;
                anomalies.Damaged += drops[i] == E57Drop.Damaged ? 1 : 0;
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
                while (end < result.Points && drops[end] == 0)
                    end++;
                if (kept < first && end > first)
                    for (int c = 0; c < ColumnTable.Length; c++)
                        Move(columns + ColumnTable[c].OffsetBytes, ColumnTable[c].Type.SizeOf(), first, kept, end - first);
                kept += end - first;
                first = end;
                while (first < result.Points && drops[first] != 0)
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
}
