using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Scenes
{
    /// <summary>Writes a scan as a LAS 1.4 file of point format 7. If disposed before <see cref="Complete"/>, it leaves no
    /// file.</summary>
    internal sealed class LasReturnSink : IReturnSink, IDisposable
    {
        const int PointsAtOnce = 65_536;

        readonly LasWriter m_writer;
        readonly PointBatch m_batch;
        NativeArray<PointColumn> m_columns;
        NativeArray<int> m_noOrder;

        public LasReturnSink(string path)
        {
            var transform = TerrestrialScan.Transform;
            m_writer = LasWriter.Create(path, new LasWriterSettings
            {
                VersionMinor = 4,
                PointFormat = 7,
                Scale = transform.Scale,
                Offset = transform.Offset,
                Wkt = TerrestrialScan.Wkt,
                SystemIdentifier = "seeded terrestrial scan",
            });
            m_batch = new PointBatch(ReturnsToColumnsJob.Schema, PointsAtOnce, Allocator.Persistent);
            m_columns = new NativeArray<PointColumn>(m_batch.Schema.Count, Allocator.Persistent);
            for (int i = 0; i < m_columns.Length; i++)
                m_columns[i] = m_batch.Column(i);
            m_noOrder = new NativeArray<int>(1, Allocator.Persistent);
        }

        public void Append(NativeArray<ScanReturn> returns) => Append(returns, m_noOrder, false, returns.Length);

        public void Append(NativeArray<ScanReturn> returns, NativeArray<int> returnNumber) =>
            Append(returns, returnNumber, true, returnNumber.Length);

        void Append(NativeArray<ScanReturn> returns, NativeArray<int> returnNumber, bool hasOrder, int count)
        {
            for (int first = 0; first < count; first += PointsAtOnce)
            {
                m_batch.Count = Math.Min(PointsAtOnce, count - first);
                new ReturnsToColumnsJob
                {
                    Returns = returns,
                    ReturnOfIndex = returnNumber,
                    HasOrder = hasOrder,
                    FirstIndex = first,
                    Count = m_batch.Count,
                    Bytes = m_batch.Bytes,
                    Columns = m_columns,
                }.Run();
                m_writer.Append(m_batch);
            }
        }

        public void Complete() => m_writer.Complete();

        public void Dispose()
        {
            m_writer.Dispose();
            m_batch.Dispose();
            if (!m_columns.IsCreated)
                return;
            m_columns.Dispose();
            m_noOrder.Dispose();
        }
    }

    /// <summary>The seeded scan as a LAS file: 36 bytes a point.</summary>
    public static class LasScan
    {
        /// <summary>Writes the file as a coroutine. It exists, complete, when the work has ended, and not at all if the work
        /// was cancelled or failed.</summary>
        public static IEnumerator<JobStep> Run(string path, long points, uint seed, ScanOrder order = ScanOrder.Strip,
            StageProgress progress = null)
        {
            using var las = new LasReturnSink(path);
            yield return JobStep.Of(OrderedScan.Run(points, seed, order, las, progress));
            yield return JobStep.Of(PoolTask.Run(path, () =>
            {
                las.Complete();
                return path;
            }, _ => { }));
        }
    }
}
