using System;
using System.Collections.Generic;
using FastPoints.Drawing;
using FastPoints.Picture;
using FastPoints.Reading;
using FastPoints.Sampling;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Evaluation
{
    /// <summary>Measures how far samples of a source are from the full cloud: distances, cells left uncovered, evenness,
    /// pictures. The full cloud is read in three scans (a fourth to look points up) in bounded memory, whatever its size: a
    /// uniform choice of <see cref="MaxQueries"/> points, occupied cells, three pictures. The results depend on no number of
    /// threads.</summary>
    public sealed class CompareSamples : IDisposable
    {
        /// <summary>Points of the full cloud from which distances are measured: all, or this many of a uniform sample.</summary>
        public const int MaxQueries = 200_000;

        public const int LookedUpPerSample = 4096;
        public const int DefaultWidthPx = 640, DefaultHeightPx = 360;
        const uint QuerySeed = 0x9E3779B9; // Not the samplers' own, so that no sample is measured by itself.

        const int PointsPerSlice = 1 << 17;

        static readonly ViewDirection[] s_views = { ViewDirection.Top, ViewDirection.Front, ViewDirection.Iso };

        readonly PointReader m_reader;
        readonly PictureOptions m_options;
        readonly PicturePlan[] m_plans = new PicturePlan[s_views.Length];
        readonly List<double3> m_lookedUp = new List<double3>();
        readonly List<SampleError> m_measured = new List<SampleError>();
        CellOccupancy m_cloud;
        NativeArray<double3> m_queries;
        int m_queryCount;
        ErrorGrid m_grid;

        public CompareSamples(PointReader reader, PictureOptions options, int widthPx = DefaultWidthPx,
            int heightPx = DefaultHeightPx)
        {
            m_reader = reader;
            m_options = options;
            WidthPx = widthPx;
            HeightPx = heightPx;
        }

        public int WidthPx { get; }
        public int HeightPx { get; }
        public BoundsGeo Bounds => m_grid.Bounds;

        /// <summary>Of all points, smooth: <see cref="PictureCanvas.MaxSamplesPerEdge"/> samples along a pixel's edge.</summary>
        public RgbaImage[] FullViews { get; private set; }

        /// <summary>All points as samples are drawn, with one sample a pixel: the error of the pixels alone.</summary>
        internal ImageError Floor { get; private set; }

        public long PointCount { get; private set; }

        public IEnumerator<JobStep> Prepare(StageProgress progress)
        {
            if (!m_reader.BlocksAreKnown)
            {
                progress?.Begin(PreviewSampling.FindBlocksStage);
                yield return JobStep.Of(m_reader.IndexBlocks());
            }
            progress?.Begin("reference sample");
            using (var sampler = new FileOrderSampler(m_reader, MaxQueries, QuerySeed))
            {
                yield return JobStep.Of(sampler.Run(0, progress));
                using var sample = sampler.TakeSample();
                yield return JobStep.Of(Prepare(sample, progress));
            }
            progress?.End();
        }

        IEnumerator<JobStep> Prepare(PreviewSample sample, StageProgress progress)
        {
            PointCount = sample.PointsInSource;
            var ranges = new DisplayRanges();
            yield return JobStep.Of(ranges.Measure(sample.Points, sample.Transform, m_options.UpAxis));
            m_grid = new ErrorGrid(ranges.Robust);
            for (int view = 0; view < s_views.Length; view++)
                m_plans[view] = new PicturePlan(OptionsFor(s_views[view]), ranges, sample.Transform);

            m_queries = new NativeArray<double3>(Math.Max(1, sample.Count), Allocator.Persistent);
            using (var loaded = new NativeReference<int>(Allocator.Persistent))
            {
                var loading = new LoadPositionsJob
                {
                    Bytes = sample.Points.Bytes,
                    Positions = PositionColumns.Of(sample.Points),
                    Transform = sample.Transform,
                    Count = sample.Count,
                    Points = m_queries,
                    Loaded = loaded,
                }.Schedule();
                try
                {
                    yield return loading;
                }
                finally
                {
                    loading.Complete();
                }
                m_queryCount = loaded.Value;
            }

            progress?.Begin("reference");
            m_cloud = new CellOccupancy(Allocator.Persistent);
            using var pass = new ReferencePass(m_reader, m_grid, m_plans, m_cloud, WidthPx, HeightPx);
            yield return JobStep.Of(pass.ChooseSizes(sample.Points, PointCount));
            yield return JobStep.Of(pass.Run(progress));
            yield return JobStep.Of(pass.Resolve());
            FullViews = pass.SmoothImages;
            Floor = SampleError.Mean(pass.Images, FullViews, m_options.Background);
        }

        /// <summary>Coroutine: measures a sample, which must be a part of the source; fills
        /// <paramref name="error"/>.</summary>
        /// <param name="points">As the source stores them; positions that are not finite are passed over. Stays the
        /// caller's, and must not change meanwhile.</param>
        /// <param name="viewsAtSameCount">The views of a uniform sample of as many points, to compare with; null for
        /// none.</param>
        public IEnumerator<JobStep> Measure(PointBatch points, int count, PositionTransform transform,
            RgbaImage[] viewsAtSameCount, SampleError error)
        {
            error.Points = count;
            error.Fraction = PointCount == 0 ? 1 : count / (double)PointCount;
            yield return JobStep.Of(MeasureDistances(points, count, transform, error));
            yield return JobStep.Of(MeasureCells(points, count, transform, error));

            int countBefore = points.Count;
            points.Count = count;
            try
            {
                error.Views = new RgbaImage[s_views.Length];
                for (int view = 0; view < s_views.Length; view++)
                    yield return JobStep.Of(Draw(points, view, error));
            }
            finally
            {
                points.Count = countBefore;
            }
            error.Picture = SampleError.Mean(error.Views, FullViews, m_options.Background);
            yield return default;
            if (viewsAtSameCount != null)
                error.PictureAtSameCount = SampleError.Mean(error.Views, viewsAtSameCount, m_options.Background);
            m_measured.Add(error);
        }

        IEnumerator<JobStep> MeasureDistances(PointBatch points, int count, PositionTransform transform, SampleError error)
        {
            using var tree = new PointTree();
            yield return JobStep.Of(tree.Build(points, count, transform));
            yield return JobStep.Of(tree.Measure(m_queries, m_queryCount, math.length(Bounds.Size),
                found => error.Distance = found));
            error.LookedUp = Math.Min(LookedUpPerSample, tree.Count);
            for (int i = 0; i < error.LookedUp; i++)
                m_lookedUp.Add(tree.Points[(int)((long)i * tree.Count / error.LookedUp)]);
        }

        IEnumerator<JobStep> MeasureCells(PointBatch points, int count, PositionTransform transform, SampleError error)
        {
            JobHandle measured = default;
            var found = new NativeReference<CellError>(Allocator.Persistent);
            using var cells = new CellOccupancy(Allocator.Persistent);
            try
            {
                for (int first = 0; first < count; first += PointsPerSlice)
                    measured = new CountSampledCellsJob
                    {
                        Sample = points.Bytes,
                        Positions = PositionColumns.Of(points),
                        Transform = transform,
                        First = first,
                        Count = Math.Min(PointsPerSlice, count - first),
                        Grid = m_grid,
                        CellsOf128th = cells.CellsOf128th,
                        PointsOfBlock = cells.PointsOfBlock,
                    }.Schedule(measured);
                measured = new CompareOccupancyJob
                {
                    CellsOfCloud = m_cloud.CellsOf128th,
                    PointsOfCloud = m_cloud.PointsOfBlock,
                    CellsOfSample = cells.CellsOf128th,
                    PointsOfSample = cells.PointsOfBlock,
                    Error = found,
                }.Schedule(measured);
                yield return measured;
                measured.Complete();
                error.Cells = found.Value;
            }
            finally
            {
                measured.Complete();
                found.Dispose();
            }
        }

        IEnumerator<JobStep> Draw(PointBatch points, int view, SampleError error)
        {
            var plan = m_plans[view];
            if (plan.UsesAutoSize)
                plan.SizePx = PointSizing.MinPx;
            using var canvas = new PictureCanvas(WidthPx, HeightPx, Allocator.Persistent);
            yield return JobStep.Of(SamplePicture.ChooseSize(canvas, points, plan, points.Count));
            yield return JobStep.Of(SamplePicture.Draw(canvas, points, plan, null));
            yield return JobStep.Of(DrawCloud.Resolve(canvas, plan));
            error.Views[view] = canvas.ToImage();
        }

        /// <summary>Coroutine, with the stage <c>look up</c>: looks for <see cref="LookedUpPerSample"/> points of
        /// each sample that was measured in the full cloud, and fills their <see cref="SampleError.Found"/>.</summary>
        public IEnumerator<JobStep> LookUp(StageProgress progress)
        {
            progress?.Begin("look up");
            using (var table = new PositionTable(m_lookedUp.ToArray(), Allocator.Persistent))
            {
                yield return JobStep.Of(SeeAll(table, progress));
                int next = 0;
                foreach (var error in m_measured)
                {
                    error.Found = 0;
                    for (int i = 0; i < error.LookedUp; i++)
                        error.Found += table.WasSeen(m_lookedUp[next++]) ? 1 : 0;
                }
            }
            progress?.End();
        }

        IEnumerator<JobStep> SeeAll(PositionTable table, StageProgress progress)
        {
            var filled = new FillPositionTableJob
            {
                Positions = table.Positions,
                Count = table.Count,
                Slots = table.Slots,
                States = table.States,
            }.Schedule();
            try
            {
                yield return filled;
            }
            finally
            {
                filled.Complete();
            }
            var wanted = m_reader.Info.Schema.Select(AttributeNames.X, AttributeNames.Y, AttributeNames.Z);
            var pass = new LookUpPass(m_reader.Info.Transform, table);
            yield return JobStep.Of(SourceScan.Run(m_reader, wanted, pass, SourceScan.SlotsFor(m_reader, wanted), progress));
        }

        PictureOptions OptionsFor(ViewDirection view) => new PictureOptions
        {
            WidthPx = WidthPx,
            HeightPx = HeightPx,
            View = view,
            FovDegrees = m_options.FovDegrees,
            UpAxis = m_options.UpAxis,
            Color = m_options.Color,
            PointSizePx = m_options.PointSizePx,
            RoundPoints = m_options.RoundPoints,
            ParaboloidPoints = m_options.ParaboloidPoints,
            FillsHoles = m_options.FillsHoles,
            Background = m_options.Background,
            EdlStrength = m_options.EdlStrength,
            LitFraction = m_options.LitFraction,
            LightAzimuth = m_options.LightAzimuth,
            LightElevation = m_options.LightElevation,
        };

        public void Dispose()
        {
            m_cloud?.Dispose();
            if (m_queries.IsCreated)
                m_queries.Dispose();
        }

        sealed class LookUpPass : IBlockConsumer
        {
            readonly PositionTransform m_transform;
            readonly PositionTable m_table;

            public LookUpPass(PositionTransform transform, PositionTable table)
            {
                m_transform = transform;
                m_table = table;
            }

            public JobHandle Schedule(BlockRead read, int slot, JobHandle decoded) => new MarkSeenJob
            {
                Block = read.Points.Bytes,
                Result = read.Result,
                Columns = PositionColumns.Of(read.Points),
                Transform = m_transform,
                Slots = m_table.Slots,
                States = m_table.States,
            }.Schedule(decoded);

            public void Completed(BlockRead read, int slot) { }
        }
    }
}
