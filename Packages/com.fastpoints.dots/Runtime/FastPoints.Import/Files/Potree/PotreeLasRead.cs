using System;
using System.Collections.Generic;
using FastPoints.Base;
using FastPoints.Points;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Files
{
    /// <summary>
    /// A slot for nodes that are LAS or LAZ files: the file is opened for its range, its slots decode, and jobs move their
    /// columns to the cloud's grid.
    /// </summary>
    /// <remarks>A header and a chunk table are read on the main thread, some hundred bytes, and the file's slots are made anew
    /// for each node: these files are for being converted, not for streaming.</remarks>
    sealed class PotreeLasRead : BlockRead
    {
        /// <summary>A slot of the node's file, and where its columns are.</summary>
        struct Part
        {
            public BlockRead Read;
            public NativeArray<PointColumn> Columns;
        }

        readonly Potree1Reader m_reader;
        readonly Allocator m_allocator;
        readonly int3 m_position;
        readonly List<Part> m_parts = new List<Part>();
        NativeReference<DecodeResult> m_result;
        NativeArray<PointColumn> m_columns;
        PointReader m_file;
        bool m_isBusy;
        bool m_isDisposed;

        public PotreeLasRead(Potree1Reader reader, PointSchema wanted, int capacity, Allocator allocator)
        {
            foreach (var column in wanted)
                if (!HasColumn(reader.Info.Schema, column))
                    throw new ArgumentException("the cloud has no attribute " + column, nameof(wanted));
            m_reader = reader;
            m_allocator = allocator;
            Points = new PointBatch(wanted, capacity, allocator);
            m_position = new int3(OffsetOf(AttributeNames.X), OffsetOf(AttributeNames.Y), OffsetOf(AttributeNames.Z));
            m_result = new NativeReference<DecodeResult>(allocator);
            m_columns = new NativeArray<PointColumn>(ColumnsOf(Points), allocator);
            Result = m_result;
        }

        public override void Begin(BlockRange range)
        {
            if (m_isBusy)
                throw new InvalidOperationException("the slot is still reading; Complete it first");
            m_reader.CheckRange(range, Points.Capacity);
            Range = range;
            FirstPoint = m_reader.FirstPointOfBlock(range.Block) + range.First;
            Points.Count = 0;
            m_result.Value = default;
            Decoded = default;
            m_isBusy = true;
            if (range.Count == 0)
                return;
            m_file = Open(range.Block);
            if (m_file != null)
                Decoded = Schedule(range);
        }

        /// <returns>Null for a file that cannot be read as one of the cloud's nodes, with a warning.</returns>
        PointReader Open(int block)
        {
            string path = m_reader.PathOf(block);
            PointReader file = null;
            string problem;
            try
            {
                using (var source = FileSource.Open(path))
                    file = LasReader.Open(source);
                problem = FindProblem(file);
                if (problem == null)
                    return file;
            }
            catch (PointCloudException e)
            {
                problem = e.Message;
            }
            file?.Dispose();
            m_reader.TellBroken(block, "its file cannot be read: its points are left out", problem, -1);
            return null;
        }

        string FindProblem(PointReader file)
        {
            foreach (var column in Points.Schema)
                if (!HasColumn(file.Info.Schema, column))
                    return "it has no attribute " + column;
            double3 scale = file.Info.Transform.Scale, wanted = m_reader.Info.Transform.Scale;
            if (math.any(math.abs(scale - wanted) > math.abs(wanted) * 1e-9))
                return "its scale is not the cloud's";
            return file.BlocksAreKnown ? null : "its chunk table is lost";
        }

        JobHandle Schedule(BlockRange range)
        {
            var corner = (m_file.Info.Transform.Offset - m_reader.Info.Transform.Offset) / m_reader.Info.Transform.Scale;
            if (math.any(math.abs(corner) > int.MaxValue))
            {
                m_reader.TellBroken(range.Block, "lies beyond the 32-bit grid of the cloud: its points are left out", null, -1);
                return default;
            }
            JobHandle done = default;
            for (int block = 0; block < m_file.BlockCount; block++)
            {
                long start = m_file.FirstPointOfBlock(block);
                long begin = Math.Max(start, range.First);
                long end = Math.Min(start + m_file.PointsInBlock(block), (long)range.First + range.Count);
                if (begin >= end)
                    continue;
                var part = new Part { Read = m_file.CreateRead(Points.Schema, (int)(end - begin), m_allocator) };
                part.Columns = new NativeArray<PointColumn>(ColumnsOf(part.Read.Points), m_allocator);
                m_parts.Add(part);
                part.Read.Begin(new BlockRange(block, (int)(begin - start), (int)(end - begin)));
                done = Move(part, (int)(begin - range.First), (int3)math.round(corner), done);
            }
            return done;
        }

        JobHandle Move(Part part, int first, int3 shift, JobHandle before) => new MovePotreeJob
        {
            Input = part.Read.Points.Bytes,
            Decoded = part.Read.Result,
            From = part.Columns,
            To = m_columns,
            Columns = Points.Bytes,
            Result = m_result,
            Position = m_position,
            Shift = shift,
            First = first,
            Capacity = part.Read.Range.Count,
        }.Schedule(JobHandle.CombineDependencies(before, part.Read.Decoded));

        public override void Complete()
        {
            if (!m_isBusy)
                throw new InvalidOperationException("the slot has no range in flight");
            m_isBusy = false;
            Decoded.Complete();
            try
            {
                foreach (var part in m_parts)
                    part.Read.Complete();
                Points.Count = m_result.Value.Points;
                if (m_result.Value.Error != PotreeError.None)
                    m_reader.TellBroken(Range.Block, "has positions beyond the 32-bit grid of the cloud: they are at its edge", null, -1);
                else if (m_file != null && Points.Count < Range.Count)
                    m_reader.TellBroken(Range.Block, "its file breaks off", m_file.Info.Warnings.Count > 0
                        ? m_file.Info.Warnings[m_file.Info.Warnings.Count - 1].ToString() : m_file.Info.Path, -1);
            }
            finally
            {
                Close();
            }
        }

        public override void Dispose()
        {
            if (m_isDisposed)
                return;
            m_isDisposed = true;
            m_isBusy = false;
            Decoded.Complete();
            Close();
            Points.Dispose();
            m_columns.Dispose();
            m_result.Dispose();
        }

        /// <summary>Lets the node's file go; no job uses it any more.</summary>
        void Close()
        {
            foreach (var part in m_parts)
            {
                part.Read.Dispose();
                part.Columns.Dispose();
            }
            m_parts.Clear();
            m_file?.Dispose();
            m_file = null;
        }

        static PointColumn[] ColumnsOf(PointBatch batch)
        {
            var columns = new PointColumn[batch.Schema.Count];
            for (int i = 0; i < columns.Length; i++)
                columns[i] = batch.Column(i);
            return columns;
        }

        int OffsetOf(string name)
        {
            int index = Points.Schema.IndexOf(name);
            return index < 0 ? -1 : Points.Column(index).OffsetBytes;
        }

        static bool HasColumn(PointSchema schema, PointAttribute column)
        {
            int index = schema.IndexOf(column.Name);
            return index >= 0 && schema[index].Type == column.Type;
        }
    }
}
