using System;
using System.Collections.Generic;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Reading
{
    [BurstCompile]
    unsafe struct FillTileColumnsJob : IJobFor
    {
        public const int PointsPerPiece = 1 << 14; // A piece takes less than a millisecond of managed code.

        const int BatchLength = ColumnValues.BatchLength;

        [ReadOnly] public NativeArray<byte> Input;
        [ReadOnly] public NativeReference<DecodeResult> Decoded;
        [ReadOnly] public NativeArray<TileColumn> Columns;
        public int Capacity; // Points that both input and output can hold.
        [NativeDisableParallelForRestriction] public NativeArray<byte> Output; // Pieces write to disjoint rows.

        public static int PieceCount(int points) => (points + PointsPerPiece - 1) / PointsPerPiece;

        public void Execute(int index)
        {
            int first = index * PointsPerPiece;
            int end = math.min(first + PointsPerPiece, math.min(Decoded.Value.Points, Capacity));
            if (end <= first)
                return;
            byte* input = (byte*)Input.GetUnsafeReadOnlyPtr();
            byte* output = (byte*)Output.GetUnsafePtr();
            for (int i = 0; i < Columns.Length; i++)
            {
                var column = Columns[i];
                int size = column.To.Type.SizeOf();
                byte* from = input + column.From.OffsetBytes;
                byte* to = output + column.To.OffsetBytes;
                switch (column.Kind)
                {
                    case TileColumnKind.Copy:
                        UnsafeUtility.MemCpy(to + (long)first * size, from + (long)first * size, (long)(end - first) * size);
                        break;
                    case TileColumnKind.Zero:
                        UnsafeUtility.MemClear(to + (long)first * size, (long)(end - first) * size);
                        break;
                    case TileColumnKind.Real:
                        ToReals(column, from, to, first, end);
                        break;
                    default:
                        ToIntegers(column, from, to, first, end);
                        break;
                }
            }
        }

        static void ToReals(in TileColumn column, byte* from, byte* to, int first, int end)
        {
            double* values = stackalloc double[BatchLength];
            double scale = column.Scale, offset = column.Offset;
            for (; first < end; first += BatchLength)
            {
                int length = math.min(BatchLength, end - first);
                ColumnValues.ToDoubles(from, column.From.Type, first, length, values);
                if (column.To.Type == AttributeType.Float32)
                    for (int i = 0; i < length; i++)
                        ((float*)to)[first + i] = (float)(values[i] * scale + offset);
                else
                    for (int i = 0; i < length; i++)
                        ((double*)to)[first + i] = values[i] * scale + offset;
            }
        }

        static void ToIntegers(in TileColumn column, byte* from, byte* to, int first, int end)
        {
            ulong* bits = stackalloc ulong[BatchLength];
            long factor = column.Factor, shift = column.Shift;
            bool isPosition = column.Kind == TileColumnKind.Position;
            long max = isPosition ? CommonGrid.Limit / math.max(1, math.abs(factor)) : long.MaxValue;
            bool isUnsigned64 = column.From.Type == AttributeType.UInt64;
            for (; first < end; first += BatchLength)
            {
                int length = math.min(BatchLength, end - first);
                ColumnValues.ToBits(from, column.From.Type, first, length, bits);
                if (isPosition)
                {
                    for (int i = 0; i < length; i++)
                    {
                        long value = (long)bits[i];
                        bool isOut = value < 0 ? isUnsigned64 || value < -max : value > max;
                        ((long*)to)[first + i] = isOut ? CommonGrid.InvalidPosition : value * factor + shift;
                    }
                    continue;
                }
                switch (column.To.Type.SizeOf())
                {
                    case 1:
                        for (int i = 0; i < length; i++)
                            to[first + i] = (byte)((long)bits[i] * factor);
                        break;
                    case 2:
                        for (int i = 0; i < length; i++)
                            ((ushort*)to)[first + i] = (ushort)((long)bits[i] * factor);
                        break;
                    case 4:
                        for (int i = 0; i < length; i++)
                            ((uint*)to)[first + i] = (uint)((long)bits[i] * factor);
                        break;
                    default:
                        for (int i = 0; i < length; i++)
                            ((ulong*)to)[first + i] = (ulong)((long)bits[i] * factor);
                        break;
                }
            }
        }
    }

    sealed class TiledRead : SlotRead
    {
        readonly TiledReader m_reader;
        readonly int m_capacity;
        readonly Allocator m_allocator;
        Tile m_tile;
        BlockRead m_inner;
        NativeArray<TileColumn> m_columns;

        public TiledRead(TiledReader reader, PointSchema wanted, int capacity, Allocator allocator)
            : base(reader, wanted, capacity, allocator)
        {
            m_reader = reader;
            m_capacity = capacity;
            m_allocator = allocator;
        }

        protected override JobHandle Schedule(BlockRange range)
        {
            var tile = m_reader.TileOfBlock(range.Block);
            if (tile != m_tile)
                OpenTile(tile);
            m_inner.Dependency = Dependency;
            m_inner.Fetched = TakeFetched();
            m_inner.Begin(new BlockRange(range.Block - tile.FirstBlock, range.First, range.Count));
            Result = m_inner.Result;
            return new FillTileColumnsJob
            {
                Input = m_inner.Points.Bytes,
                Decoded = m_inner.Result,
                Columns = m_columns,
                Capacity = range.Count,
                Output = Points.Bytes,
            }.ScheduleParallel(FillTileColumnsJob.PieceCount(range.Count), 1, m_inner.Decoded);
        }

        protected override void EndRead()
        {
            try
            {
                m_inner.Complete();
            }
            finally
            {
                m_reader.TakeWarnings(m_tile);
            }
        }

        protected override void DisposeMore() => Release();

        void OpenTile(Tile tile)
        {
            Release();
            m_reader.Acquire(tile);
            m_tile = tile;
            m_inner = tile.Reader.CreateRead(WantedOf(tile), Math.Min(m_capacity, tile.MaxPointsPerBlock), m_allocator);
            var columns = new List<TileColumn>();
            for (int i = 0; i < Points.Schema.Count; i++)
            {
                var to = Points.Schema[i];
                int from = m_inner.Points.Schema.IndexOf(to.Name);
                var column = TileSchema.Convert(tile, from < 0 ? null : m_inner.Points.Schema[from], to, m_reader.Info.Transform);
                column.From = from < 0 ? default : m_inner.Points.Column(from);
                column.To = Points.Column(i);
                columns.Add(column);
            }
            m_columns = new NativeArray<TileColumn>(columns.ToArray(), m_allocator);
        }

        // If the tile has none of the requested attributes, X, so that its points are counted.
        PointSchema WantedOf(Tile tile)
        {
            var names = new string[Points.Schema.Count];
            for (int i = 0; i < names.Length; i++)
                names[i] = Points.Schema[i].Name;
            var wanted = tile.Schema.Select(names);
            return wanted.Count > 0 || names.Length == 0 ? wanted : tile.Schema.Select(AttributeNames.X);
        }

        void Release()
        {
            if (m_tile == null)
                return;
            m_inner?.Dispose();
            m_inner = null;
            if (m_columns.IsCreated)
                m_columns.Dispose();
            m_reader.Release(m_tile);
            m_tile = null;
        }
    }
}
