using System;
using System.Collections.Generic;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Scenes
{
    /// <summary>A seeded terrestrial laser scan of a <see cref="StreetScene"/> from its three stations: exactly the requested
    /// number of points, the same bytes for a seed on any number of threads, in bounded memory.</summary>
    internal static class TerrestrialScan
    {
        const int ReturnsPerBatch = 1 << 18;

        /// <summary>UTM-sized: zone 32 north, and heights near 120 m.</summary>
        public static PositionTransform Transform => new PositionTransform
        {
            Scale = new double3(ScanReturn.Step, ScanReturn.Step, ScanReturn.Step),
            Offset = new double3(441000, 5612000, 120),
        };

        /// <summary>Name of the coordinate system for a LAS record, as OGC well-known text.</summary>
        public const string Wkt =
            "PROJCS[\"WGS 84 / UTM zone 32N\",GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,298.257223563]],"
            + "PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433]],PROJECTION[\"Transverse_Mercator\"],"
            + "PARAMETER[\"latitude_of_origin\",0],PARAMETER[\"central_meridian\",9],PARAMETER[\"scale_factor\",0.9996],"
            + "PARAMETER[\"false_easting\",500000],PARAMETER[\"false_northing\",0],UNIT[\"metre\",1],AXIS[\"Easting\",EAST],"
            + "AXIS[\"Northing\",NORTH],AUTHORITY[\"EPSG\",\"32632\"]]";

        /// <summary>Scans as a coroutine. <paramref name="take"/> gets the returns batch by batch in the order of the scan,
        /// on the main thread; a batch is valid only during the call.</summary>
        public static IEnumerator<JobStep> Run(long points, uint seed, Action<NativeArray<ScanReturn>> take,
            StageProgress progress)
        {
            if (points < 1)
                throw new ArgumentOutOfRangeException(nameof(points), points, "a scan has at least one point");
            using var scene = new StreetScene(seed, Allocator.Persistent);
            var shadow = new SunShadow(Allocator.Persistent);
            var buffers = new[] { new Batch(), new Batch() };
            JobHandle cast = default;
            try
            {
                cast = new SunShadow.CastShadowsJob { Objects = scene.Objects, TopOfCell = shadow.TopOfCell }.Schedule();
                yield return cast;
                cast.Complete();

                long done = 0;
                for (int station = 0; station < StreetScene.Stations.Length; station++)
                {
                    long share = (points * (station + 1) / StreetScene.Stations.Length) - done;
                    if (share == 0)
                        continue;
                    var trace = new TraceLinesJob
                    {
                        Objects = scene.Objects,
                        TopOfShadow = shadow.TopOfCell,
                        Station = StreetScene.Stations[station],
                        StationNumber = (ushort)(station + 1),
                        Seed = seed,
                    };

                    // A coarse turn shows how many returns a pulse brings, which gives the angle step for the wanted points.
                    trace.LinesPerTurn = 64;
                    trace.RaysPerLine = 48;
                    buffers[0].Schedule(trace, 0, trace.LinesPerTurn);
                    yield return buffers[0].Handle;
                    double returnsPerPulse = Math.Max(0.1, buffers[0].Complete().Length / (64.0 * 48));
                    const double sweep = TraceLinesJob.HighestElevation - TraceLinesJob.LowestElevation;
                    double angle = Math.Sqrt(2 * Math.PI * sweep * returnsPerPulse / share);
                    trace.LinesPerTurn = Math.Max(3, (int)Math.Ceiling(2 * Math.PI / angle));
                    trace.RaysPerLine = Math.Max(2, (int)Math.Ceiling(sweep / angle));
                    int lines = Math.Min(trace.LinesPerTurn,
                        Math.Max(1, ReturnsPerBatch / (trace.RaysPerLine * TraceLinesJob.MaxReturns)));

                    // Turns repeat until there are enough points: one batch is traced while the one before is taken.
                    int firstLine = 0;
                    buffers[0].Schedule(trace, firstLine, lines);
                    for (int turn = 0; share > 0; turn ^= 1)
                    {
                        firstLine += lines;
                        buffers[turn ^ 1].Schedule(trace, firstLine, lines);
                        yield return buffers[turn].Handle;
                        var returns = buffers[turn].Complete();
                        int count = (int)Math.Min(returns.Length, share);
                        if (count > 0)
                            take(returns.GetSubArray(0, count));
                        share -= count;
                        done += count;
                        progress?.Report((double)done / points, done, 0);
                    }
                    buffers[0].Complete();
                    buffers[1].Complete();
                }
            }
            finally
            {
                cast.Complete();
                buffers[0].Dispose();
                buffers[1].Dispose();
                shadow.TopOfCell.Dispose();
            }
        }

        sealed class Batch : IDisposable
        {
            NativeArray<ScanReturn> m_returns;
            NativeArray<int> m_countOfLine;
            NativeReference<int> m_count;

            public JobHandle Handle { get; private set; }

            public void Schedule(TraceLinesJob trace, int firstLine, int lines)
            {
                int returnsPerLine = trace.RaysPerLine * TraceLinesJob.MaxReturns;
                if (m_countOfLine.Length < lines || m_returns.Length < lines * returnsPerLine)
                {
                    Dispose();
                    m_returns = new NativeArray<ScanReturn>(lines * returnsPerLine, Allocator.Persistent,
                        NativeArrayOptions.UninitializedMemory);
                    m_countOfLine = new NativeArray<int>(lines, Allocator.Persistent);
                    m_count = new NativeReference<int>(Allocator.Persistent);
                }
                trace.FirstLine = firstLine;
                trace.ReturnsOfLine = m_returns;
                trace.CountOfLine = m_countOfLine;
                var traced = trace.ScheduleParallel(lines, 1, default);
                Handle = new CompactReturnsJob
                {
                    Returns = m_returns,
                    CountOfLine = m_countOfLine,
                    Lines = lines,
                    ReturnsPerLine = returnsPerLine,
                    Count = m_count,
                }.Schedule(traced);
                JobHandle.ScheduleBatchedJobs();
            }

            public NativeArray<ScanReturn> Complete()
            {
                Handle.Complete();
                return m_returns.GetSubArray(0, m_count.Value);
            }

            public void Dispose()
            {
                Handle.Complete();
                if (!m_returns.IsCreated)
                    return;
                m_returns.Dispose();
                m_countOfLine.Dispose();
                m_count.Dispose();
            }
        }
    }

    [BurstCompile]
    internal struct CompactReturnsJob : IJob
    {
        public NativeArray<ScanReturn> Returns;
        [ReadOnly] public NativeArray<int> CountOfLine;
        public int Lines;
        public int ReturnsPerLine;
        public NativeReference<int> Count;

        public void Execute()
        {
            int end = 0;
            for (int line = 0; line < Lines; line++)
            {
                int start = line * ReturnsPerLine, count = CountOfLine[line];
                if (start != end)
                    for (int i = 0; i < count; i++)
                        Returns[end + i] = Returns[start + i];
                end += count;
            }
            Count.Value = end;
        }
    }
}
