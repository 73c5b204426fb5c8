using FastPoints.Core;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Octrees
{
    [BurstCompile]
    unsafe struct SpreadPotreeJob : IJob
    {
        // The upper 16 bits of x, y and z as a Morton code, then the lower 16.
        public const int PositionBytes = 16;

        // 16 bits of red, green and blue as a Morton code.
        public const int ColorBytes = 8;

        [ReadOnly] public NativeArray<byte> Tile;
        [ReadOnly] public NativeArray<FieldCopy> Copies;
        [ReadOnly] public NativeReference<DecompressState> State;
        public NativeArray<byte> Columns;
        public PotreeSpecialColumns Special;
        public PotreeAttributeKind Kind;
        public int BytesPerPoint;
        public int FirstCopy;
        public int CopyCount;
        public int FirstInTile;
        public int First;
        public int Count;

        public void Execute()
        {
            if (State.Value.IsBroken)
                return;
            byte* from = (byte*)Tile.GetUnsafeReadOnlyPtr() + (long)FirstInTile * BytesPerPoint;
            byte* columns = (byte*)Columns.GetUnsafePtr();
            var copies = (FieldCopy*)Copies.GetUnsafeReadOnlyPtr() + FirstCopy;
            if (Kind == PotreeAttributeKind.Position)
                SpreadPositions((ulong*)from, columns);
            else if (Kind == PotreeAttributeKind.Color)
                SpreadColors((ulong*)from, copies, columns);
            else if (CopyCount > 0)
                PointRecords.ToColumns(from, BytesPerPoint, Count, copies, CopyCount, columns, First);
            else
                Special.DecodeNormals(from, BytesPerPoint, Count, columns, First);
        }

        // PotreeConverter subtracts the node's lowest coordinate, which an overflowing conversion sets to -1 for good: all values
        // are one step too high compared with encoding DEFAULT, so one is subtracted.
        void SpreadPositions(ulong* codes, byte* columns)
        {
            int* x = (int*)(columns + Special.Position.x) + First;
            int* y = (int*)(columns + Special.Position.y) + First;
            int* z = (int*)(columns + Special.Position.z) + First;
            bool needsX = Special.Position.x >= 0, wantsY = Special.Position.y >= 0, wantsZ = Special.Position.z >= 0;
            for (int i = 0; i < Count; i++)
            {
                Morton.Decode(codes[2 * i], out uint upperX, out uint upperY, out uint upperZ);
                Morton.Decode(codes[2 * i + 1], out uint lowerX, out uint lowerY, out uint lowerZ);
                if (needsX)
                    x[i] = (int)((upperX << 16 | lowerX & 0xFFFF) - 1);
                if (wantsY)
                    y[i] = (int)((upperY << 16 | lowerY & 0xFFFF) - 1);
                if (wantsZ)
                    z[i] = (int)((upperZ << 16 | lowerZ & 0xFFFF) - 1);
            }
        }

        // As tiles of records, which the plan's copies take apart.
        void SpreadColors(ulong* codes, FieldCopy* copies, byte* columns)
        {
            const int TilePoints = 256;
            ushort* records = stackalloc ushort[3 * TilePoints];
            for (int first = 0; first < Count; first += TilePoints)
            {
                int count = Count - first < TilePoints ? Count - first : TilePoints;
                for (int i = 0; i < count; i++)
                {
                    Morton.Decode(codes[first + i], out uint red, out uint green, out uint blue);
                    records[3 * i] = (ushort)red;
                    records[3 * i + 1] = (ushort)green;
                    records[3 * i + 2] = (ushort)blue;
                }
                PointRecords.ToColumns((byte*)records, 6, count, copies, CopyCount, columns, First + first);
            }
        }
    }
}
