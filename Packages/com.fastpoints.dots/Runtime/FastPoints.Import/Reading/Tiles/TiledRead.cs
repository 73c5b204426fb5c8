using System;
using System.Collections.Generic;
using FastPoints.Core;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Reading
{
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
                Change(tile);
            m_inner.Dependency = Dependency;
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

        void Change(Tile tile)
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

        // If the tile has none of the wanted, an attribute that suffices to count its points.
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
