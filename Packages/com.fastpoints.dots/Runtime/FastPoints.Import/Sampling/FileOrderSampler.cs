using System;
using System.Collections.Generic;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Sampling
{
    /// <summary>Scans all points, and takes one of each stratum in file order: the reference for quicker samplers. The sample
    /// has exactly min(wanted, all) points, the same ones for any number of threads and slots.</summary>
    /// <remarks>After Schütz, Mandlburger, Otepka, Wimmer, "Progressive real-time rendering of one billion points without
    /// hierarchical acceleration structures", 2020, whose shuffled order this replaces with a hashed position in each
    /// stratum.</remarks>
    internal sealed class FileOrderSampler : IBlockConsumer, IDisposable
    {
        readonly PointReader m_reader;
        readonly PointSchema m_schema;
        readonly SampleStrata m_strata;
        SampleBuffer m_buffer;
        NativeArray<PointColumn>[] m_columnsOfSlot;
        long m_pointsRead;
        long m_bytesRead;
        PreviewSample m_sample;

        public FileOrderSampler(PointReader reader, int wanted, uint seed)
        {
            m_reader = reader;
            m_schema = SampleSchema.Of(reader.Info);
            m_strata = new SampleStrata(reader.PointCount, Math.Min(wanted, PreviewSample.MaxPoints(m_schema)), seed);
        }

        public IEnumerator<JobStep> Run(int slots, StageProgress progress)
        {
            if (slots < 1)
                slots = SourceScan.SlotsFor(m_reader, m_schema);
            m_columnsOfSlot = new NativeArray<PointColumn>[slots];
            try
            {
                m_buffer = new SampleBuffer(m_schema, m_reader.Info.Transform, m_strata.Count);
                yield return JobStep.Of(SourceScan.Run(m_reader, m_schema, this, slots, progress));
                yield return JobStep.Of(m_buffer.Compact(0, m_buffer.EntryCount));
                m_sample = m_buffer.CreateSample();
                m_sample.PointsInSource = m_pointsRead;
                m_sample.BytesRead = m_bytesRead;
                m_sample.IsFullScan = true;
                m_sample.Method = "full scan, one point of each stratum";
            }
            finally
            {
                for (int i = 0; i < slots; i++)
                    if (m_columnsOfSlot[i].IsCreated)
                        m_columnsOfSlot[i].Dispose();
                m_buffer?.Dispose();
            }
        }

        public JobHandle Schedule(BlockRead read, int slot, JobHandle decoded)
        {
            if (m_strata.Count == 0)
                return decoded;
            if (!m_columnsOfSlot[slot].IsCreated)
                m_columnsOfSlot[slot] = SampleBuffer.ColumnsOf(read.Points);
            return m_buffer.Schedule(read, m_columnsOfSlot[slot], m_strata, decoded);
        }

        public void Completed(BlockRead read, int slot)
        {
            m_pointsRead += read.Points.Count;
            m_bytesRead += m_reader.BytesOfRange(read.Range);
        }

        /// <summary>Hands over the sample, once; null before the work has ended.</summary>
        public PreviewSample TakeSample()
        {
            var sample = m_sample;
            m_sample = null;
            return sample;
        }

        public void Dispose()
        {
            m_sample?.Dispose();
            m_sample = null;
        }
    }
}
