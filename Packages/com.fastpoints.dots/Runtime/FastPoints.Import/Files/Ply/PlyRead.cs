using System.Collections.Generic;
using FastPoints.Points;
using Unity.Collections;

namespace FastPoints.Files
{
    /// <summary>The common base of the slots of all PLY readers: the batch, one read, and how a range begins and ends.</summary>
    abstract class PlyRead : SlotRead
    {
        readonly PlyReader m_reader;
        readonly NativeFileRead m_file;
        NativeReference<PlyAnomalies> m_anomalies;

        protected PlyRead(PlyReader reader, PointSchema wanted, int capacity, long inputBytes, Allocator allocator)
            : base(reader, wanted, capacity, allocator)
        {
            m_reader = reader;
            m_file = new NativeFileRead(reader.Info.Path, reader.File, inputBytes, allocator);
            m_anomalies = new NativeReference<PlyAnomalies>(allocator);
        }

        protected NativeFileRead File => m_file;
        protected NativeReference<PlyAnomalies> Anomalies => m_anomalies;

        protected sealed override void EndRead() => m_file.End();

        protected sealed override void Warn(DecodeResult result)
        {
            m_reader.WarnAnomalies(m_anomalies.Value);
            if (result.Error != PlyError.None)
                m_reader.WarnBroken(Range, result);
        }

        protected virtual void DisposeTables()
        {
        }

        protected sealed override void DisposeMemory()
        {
            m_file.Dispose();
            m_anomalies.Dispose();
            DisposeTables();
        }

        protected static NativeArray<T> ToNative<T>(List<T> items, Allocator allocator) where T : unmanaged =>
            new NativeArray<T>(items.ToArray(), allocator);
    }

    /// <summary>Anomalies that a decoding job met and that cost no point.</summary>
    struct PlyAnomalies
    {
        /// <summary>Values that do not fit into their integer type.</summary>
        public int Misfits;
        public long FirstMisfitOffset;

        public int LinesWithExtraValues;
        public long FirstExtraOffset;
    }
}
