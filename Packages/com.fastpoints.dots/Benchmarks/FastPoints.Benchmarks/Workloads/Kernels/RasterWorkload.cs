using FastPoints.Drawing;
using FastPoints.Evaluation;
using FastPoints.Picture;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Benchmarks
{
    /// <summary>A seeded surface with 16-bit colour drawn into 1280 by 720 pixels on all workers, one pixel a point, lighting
    /// included. Its error is that of half the points against all of them.</summary>
    public struct RasterWorkload : IWorkload
    {
        PointBatch m_points;
        PictureCanvas m_canvas;
        PointDrawing m_drawing;
        double m_psnr;

        public string Name => "raster";
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            m_points = MakeSurface(context.Points, context.Seed);
            m_canvas = new PictureCanvas(1280, 720, Allocator.Persistent);
            var transform = new PositionTransform
            {
                Scale = new double3(0.001, 0.001, 0.001),
                Offset = new double3(690_000, 5_330_000, 500),
            };
            var bounds = PositionBounds.RunImmediate(m_points, transform).Bounds;
            var camera = CameraFraming.Frame(new PictureOptions
            {
                View = ViewDirection.Iso,
                WidthPx = m_canvas.WidthPx,
                HeightPx = m_canvas.HeightPx,
                UpAxis = UpAxis.Z,
            }, bounds, null, null, new double3(1, 1, 1));
            m_drawing = new PointDrawing
            {
                Positions = PositionColumns.Of(m_points),
                Projection = new PointProjection(camera, transform, m_canvas.WidthPx, m_canvas.HeightPx),
                Colors = ColorMapping.For(ColorMode.Rgb, new DisplayRanges { Color = ColorDepth.Bits16 }, m_points, transform),
                MaxTileSizePx = 1,
            };
            Draw(m_points.Count / 2);
            var half = m_canvas.ToImage();
            Draw(m_points.Count);
            m_psnr = ImageError.Compare(half, m_canvas.ToImage(), 0).Psnr;
        }

        public WorkloadResult Run()
        {
            Draw(m_points.Count);
            return new WorkloadResult
            {
                Points = m_points.Count,
                Bytes = (long)m_points.Count * m_points.Schema.BytesPerPoint,
                Error = m_psnr,
                ErrorUnit = "dB, half the points",
                ErrorIncreaseIsBetter = true,
            };
        }

        public void Dispose()
        {
            m_canvas.Dispose();
            m_points.Dispose();
        }

        void Draw(int count)
        {
            m_canvas.Clear();
            var drawn = m_canvas.ScheduleDraw(m_points, 0, count, m_drawing, default);
            m_canvas.ScheduleResolve(new ResolvePictureJob
            {
                Projection = m_drawing.Projection,
                EdlStrength = PictureOptions.DefaultEdlStrength,
            }, drawn).Complete();
        }

        static PointBatch MakeSurface(int count, uint seed)
        {
            var schema = new PointSchema(new[]
            {
                new PointAttribute(AttributeNames.X, AttributeType.Int32), new PointAttribute(AttributeNames.Y,
                    AttributeType.Int32),
                new PointAttribute(AttributeNames.Z, AttributeType.Int32), new PointAttribute(AttributeNames.Red,
                    AttributeType.UInt16),
                new PointAttribute(AttributeNames.Green, AttributeType.UInt16),
                new PointAttribute(AttributeNames.Blue, AttributeType.UInt16),
            });
            var batch = new PointBatch(schema, count, Allocator.Persistent) { Count = count };
            var x = batch.Column<int>(0);
            var y = batch.Column<int>(1);
            var z = batch.Column<int>(2);
            var random = new Unity.Mathematics.Random(seed);
            for (int i = 0; i < count; i++)
            {
                float px = random.NextFloat(), py = random.NextFloat();
                x[i] = (int)(px * 100_000);
                y[i] = (int)(py * 100_000);
                z[i] = (int)(8000 * math.sin(12 * px) * math.cos(9 * py));
            }
            for (int channel = 0; channel < 3; channel++)
            {
                var values = batch.Column<ushort>(3 + channel);
                for (int i = 0; i < count; i++)
                    values[i] = (ushort)(32767 + z[i] * (channel + 1) + random.NextInt(4096));
            }
            return batch;
        }
    }
}
