using System;
using System.Collections.Generic;
using FastPoints.Points;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Files
{
    /// <summary>What the slots of all PLY readers have in common: the batch, one read, and how a range begins and ends.</summary>
    abstract class PlyRead : BlockRead
    {
        readonly PlyReader m_reader;
        readonly NativeFileRead m_file;
        NativeReference<DecodeResult> m_result;
        NativeReference<PlyAnomalies> m_anomalies;
        bool m_isBusy;
        bool m_isDisposed;

        protected PlyRead(PlyReader reader, PointSchema wanted, int capacity, long inputBytes, Allocator allocator)
        {
            foreach (var attribute in wanted)
            {
                int index = reader.Info.Schema.IndexOf(attribute.Name);
                if (index < 0 || reader.Info.Schema[index].Type != attribute.Type)
                    throw new ArgumentException("the file has no attribute " + attribute, nameof(wanted));
            }
            m_reader = reader;
            Points = new PointBatch(wanted, capacity, allocator);
            m_file = new NativeFileRead(reader.Info.Path, reader.File, inputBytes, allocator);
            m_result = new NativeReference<DecodeResult>(allocator);
            m_anomalies = new NativeReference<PlyAnomalies>(allocator);
            Result = m_result;
        }

        protected NativeFileRead File => m_file;
        protected NativeReference<PlyAnomalies> Anomalies => m_anomalies;

        /// <summary>Starts the read and the job behind it.</summary>
        protected abstract JobHandle Schedule(BlockRange range);

        public sealed override void Begin(BlockRange range)
        {
            if (m_isBusy)
                throw new InvalidOperationException("the slot has a range in flight");
            if (range.Block < 0 || range.Block >= m_reader.BlockCount)
                throw new ArgumentOutOfRangeException(nameof(range), range.Block, "no such block");
            int points = m_reader.PointsInBlock(range.Block);
            if (range.First < 0 || range.Count < 0 || range.First > points - range.Count || range.Count > Points.Capacity)
                throw new ArgumentOutOfRangeException(nameof(range), "wanted points " + range.First + " + " + range.Count +
                    " of " + points + ", capacity " + Points.Capacity);
            Range = range;
            FirstPoint = m_reader.FirstPointOfBlock(range.Block) + range.First;
            Points.Count = 0;
            Decoded = Schedule(range);
            m_isBusy = true;
        }

        public sealed override void Complete()
        {
            if (!m_isBusy)
                throw new InvalidOperationException("the slot has no range in flight");
            m_isBusy = false;
            Decoded.Complete();
            m_file.End();
            var result = m_result.Value;
            Points.Count = result.Points;
            m_reader.WarnAnomalies(m_anomalies.Value);
            if (result.Error != PlyError.None)
                m_reader.WarnBroken(Range, result);
        }

        protected virtual void DisposeTables()
        {
        }

        public sealed override void Dispose()
        {
            if (m_isDisposed)
                return;
            m_isDisposed = true;
            m_isBusy = false;
            Decoded.Complete();
            m_file.Dispose();
            Points.Dispose();
            m_result.Dispose();
            m_anomalies.Dispose();
            DisposeTables();
        }

        protected static NativeArray<T> ToNative<T>(List<T> items, Allocator allocator) where T : unmanaged =>
            new NativeArray<T>(items.ToArray(), allocator);
    }

    /// <summary>What a decoding job met that is odd and costs no point.</summary>
    struct PlyAnomalies
    {
        /// <summary>Values that their integer type cannot hold.</summary>
        public int Misfits;
        public long FirstMisfitOffset;

        public int LinesWithExtraValues;
        public long FirstExtraOffset;
    }
}
