using System;
using System.Collections.Generic;
using FastPoints.Picture;
using FastPoints.Reading;
using FastPoints.Sampling;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Evaluation
{
    sealed class ReferencePass : IBlockConsumer, IDisposable
    {
        readonly PointReader m_reader;
        readonly PointSchema m_wanted;
        readonly ErrorGrid m_grid;
        readonly PicturePlan[] m_plans;
        // By view: with one sample a pixel, then with several.
        readonly PictureCanvas[] m_canvases;
        readonly CellOccupancy m_cloud;
        readonly CellOccupancy[] m_cellsOfSlot;

        public ReferencePass(PointReader reader, ErrorGrid grid, PicturePlan[] plans, CellOccupancy cloud, int widthPx,
            int heightPx)
        {
            m_reader = reader;
            m_wanted = SampleSchema.Of(reader.Info);
            m_grid = grid;
            m_plans = plans;
            m_cloud = cloud;
            m_cellsOfSlot = new CellOccupancy[SourceScan.SlotsFor(reader, m_wanted)];
            m_canvases = new PictureCanvas[2 * plans.Length];
            for (int i = 0; i < m_canvases.Length; i++)
                m_canvases[i] = new PictureCanvas(widthPx, heightPx, Allocator.Persistent,
                    i < plans.Length ? 1 : PictureCanvas.MaxSamplesPerEdge);
        }

        public RgbaImage[] Images { get; private set; } // With a picture's one sample a pixel.

        public RgbaImage[] SmoothImages { get; private set; }

        public IEnumerator<JobStep> ChooseSizes(PointBatch sample, long pointsInSource)
        {
            for (int view = 0; view < m_plans.Length; view++)
            {
                yield return JobStep.Of(SamplePicture.ChooseSize(m_canvases[view], sample, m_plans[view], pointsInSource));
                m_canvases[m_plans.Length + view].UseSizesOf(m_canvases[view]);
            }
        }

        public IEnumerator<JobStep> Run(StageProgress progress)
        {
            yield return JobStep.Of(SourceScan.Run(m_reader, m_wanted, this, m_cellsOfSlot.Length, progress));
            foreach (var cells in m_cellsOfSlot)
            {
                if (cells == null)
                    continue;
                var added = new AddOccupancyJob
                {
                    CellsOf128th = cells.CellsOf128th,
                    PointsOfBlock = cells.PointsOfBlock,
                    SumOfCells = m_cloud.CellsOf128th,
                    SumOfPoints = m_cloud.PointsOfBlock,
                }.Schedule();
                try
                {
                    yield return added;
                }
                finally
                {
                    added.Complete();
                }
            }
        }

        public IEnumerator<JobStep> Resolve()
        {
            var images = new RgbaImage[m_canvases.Length];
            for (int i = 0; i < images.Length; i++)
            {
                yield return JobStep.Of(DrawCloud.Resolve(m_canvases[i], m_plans[i % m_plans.Length]));
                images[i] = m_canvases[i].ToImage();
            }
            Images = images[..m_plans.Length];
            SmoothImages = images[m_plans.Length..];
        }

        public JobHandle Schedule(BlockRead read, int slot, JobHandle decoded)
        {
            m_cellsOfSlot[slot] ??= new CellOccupancy(Allocator.Persistent);
            var done = new CountOccupancyJob
            {
                Block = read.Points.Bytes,
                Result = read.Result,
                Positions = PositionColumns.Of(read.Points),
                Transform = m_reader.Info.Transform,
                Grid = m_grid,
                CellsOf128th = m_cellsOfSlot[slot].CellsOf128th,
                PointsOfBlock = m_cellsOfSlot[slot].PointsOfBlock,
            }.Schedule(decoded);
            for (int i = 0; i < m_canvases.Length; i++)
                done = JobHandle.CombineDependencies(done, new DrawBlockJob
                {
                    Block = read.Points.Bytes,
                    Result = read.Result,
                    Palettes = m_canvases[i].Palettes,
                    SizeOfTile = m_canvases[i].SizeOfTile,
                    Drawing = m_plans[i % m_plans.Length].DrawingOf(read.Points, m_canvases[i]),
                    Pixels = m_canvases[i].Pixels,
                }.ScheduleParallel(RasterizePointsJob.PieceCount(read.Range.Count), 1, decoded));
            return done;
        }

        public void Completed(BlockRead read, int slot) { }

        public void Dispose()
        {
            foreach (var canvas in m_canvases)
                canvas.Dispose();
            foreach (var cells in m_cellsOfSlot)
                cells?.Dispose();
        }
    }

    [BurstCompile]
    public struct AddOccupancyJob : IJob
    {
        [ReadOnly] public NativeArray<ulong> CellsOf128th;
        [ReadOnly] public NativeArray<long> PointsOfBlock;
        public NativeArray<ulong> SumOfCells;
        public NativeArray<long> SumOfPoints;

        public void Execute()
        {
            for (int word = 0; word < SumOfCells.Length; word++)
                SumOfCells[word] |= CellsOf128th[word];
            for (int block = 0; block < SumOfPoints.Length; block++)
                SumOfPoints[block] += PointsOfBlock[block];
        }
    }
}
