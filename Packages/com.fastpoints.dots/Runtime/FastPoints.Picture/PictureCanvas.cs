using System;
using FastPoints.Drawing;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Picture
{
    // A picture while it is drawn: 12 bytes a sample of native memory. Main thread. With several samples along a pixel's edge all
    // is drawn as if samples were pixels, but with points as large in the picture, and ToImage averages the samples' light.
    internal sealed class PictureCanvas : IDisposable
    {
        // Both edges, and no more than 2^27 pixels in all (1.6 GB).
        public const int MaxEdgePx = 16384;
        const long MaxPixels = 1L << 27;

        NativeArray<ulong> m_pixels;
        NativeArray<uint> m_colors;
        readonly NativeArray<uint> m_palettes;
        NativeArray<float> m_sizeOfTile;
        NativeReference<float> m_typicalSizePx;

        public PictureCanvas(int widthPx, int heightPx, Allocator allocator, int samplesPerEdge = 1)
        {
            SamplesPerEdge = samplesPerEdge;
            widthPx *= samplesPerEdge;
            heightPx *= samplesPerEdge;
            if (widthPx < 1 || heightPx < 1 || widthPx > MaxEdgePx || heightPx > MaxEdgePx ||
                (long)widthPx * heightPx > MaxPixels)
                throw new ArgumentOutOfRangeException(nameof(widthPx), widthPx + "x" + heightPx,
                    "wanted edges of 1 to " + MaxEdgePx + " pixels, and at most " + MaxPixels + " pixels");
            WidthPx = widthPx;
            HeightPx = heightPx;
            int pixels = widthPx * heightPx;
            m_pixels = new NativeArray<ulong>(pixels, allocator, NativeArrayOptions.UninitializedMemory);
            m_colors = new NativeArray<uint>(pixels, allocator, NativeArrayOptions.UninitializedMemory);
            m_sizeOfTile = new NativeArray<float>(PointSizing.TilesAlong(widthPx) * PointSizing.TilesAlong(heightPx), allocator);
            m_typicalSizePx = new NativeReference<float>(allocator);
            UseSize(PointSizing.MinPx);
            m_palettes = Drawing.Palettes.CreateAll(allocator);
            Clear();
        }

        // In samples, as all that is drawn.
        public int WidthPx { get; }
        public int HeightPx { get; }

        public const int MaxSamplesPerEdge = 4;

        public int SamplesPerEdge { get; }

        public NativeArray<ulong> Pixels => m_pixels; // Depth and colour: see PointDrawing.

        // The main light's depth map; null without. Who draws a point here draws it there, too.
        public PictureCanvas Shadows { get; private set; }
        public ShadowMapProjection ShadowMapProjection { get; private set; }

        // Of a frame without texels: none.
        public void UseShadows(in ShadowMapProjection frame)
        {
            ShadowMapProjection = frame;
            if (frame.TexelWorld > 0)
                Shadows ??= new PictureCanvas(ShadowMapProjection.EdgePx, ShadowMapProjection.EdgePx, Allocator.Persistent);
        }

        public ShadowMap ShadowMapFor(double3 eye) => ShadowMapProjection.TexelWorld > 0
            ? new ShadowMap { Pixels = Shadows.m_pixels, Shadow = ShadowMapProjection.From(eye) } : default;

        public NativeArray<uint> Palettes => m_palettes;
        public NativeArray<float> SizeOfTile => m_sizeOfTile; // Row by row from the top: see PointSizing.
        public float TypicalSizePx => m_typicalSizePx.Value; // In the median tile.

        public float MaxTileSizePx { get; private set; }

        // 1 to PointDrawing.MaxSizePx, of pixels. No drawing may be in flight.
        public void UseSize(float sizePx)
        {
            sizePx *= SamplesPerEdge;
            for (int i = 0; i < m_sizeOfTile.Length; i++)
                m_sizeOfTile[i] = sizePx;
            m_typicalSizePx.Value = sizePx;
            MaxTileSizePx = sizePx;
        }

        // Those of a picture of as many pixels with one sample each: a tile's size is the same in the world.
        public void UseSizesOf(PictureCanvas canvas)
        {
            int across = PointSizing.TilesAlong(WidthPx), acrossOther = PointSizing.TilesAlong(canvas.WidthPx);
            for (int i = 0; i < m_sizeOfTile.Length; i++)
                m_sizeOfTile[i] = SamplesPerEdge * canvas.m_sizeOfTile[
                    i / across / SamplesPerEdge * acrossOther + i % across / SamplesPerEdge];
            m_typicalSizePx.Value = canvas.TypicalSizePx;
            MaxTileSizePx = SamplesPerEdge * canvas.MaxTileSizePx;
        }

        // No drawing may be in flight.
        public unsafe void Clear()
        {
            UnsafeUtility.MemSet(m_pixels.GetUnsafePtr(), 0xFF, (long)m_pixels.Length * sizeof(ulong));
        }

        // Any number of draws may be in flight.
        public JobHandle ScheduleDraw(PointBatch points, int first, int count, PointDrawing drawing, JobHandle inputDeps)
        {
            return new RasterizePointsJob
            {
                Bytes = points.Bytes,
                Palettes = m_palettes,
                SizeOfTile = m_sizeOfTile,
                Drawing = drawing,
                First = first,
                Count = count,
                Pixels = m_pixels,
            }.ScheduleParallel(RasterizePointsJob.PieceCount(count), 1, inputDeps);
        }

        // From what was drawn with UseSize of 1, after all drawing. The final picture has this many points for each.
        public JobHandle ScheduleChooseSizes(double pointsPerPointDrawn, JobHandle inputDeps)
        {
            MaxTileSizePx = PointSizing.MaxPx;
            return new ChooseSizesJob
            {
                Pixels = m_pixels,
                WidthPx = WidthPx,
                HeightPx = HeightPx,
                PointsPerPointDrawn = pointsPerPointDrawn,
                SizeOfTile = m_sizeOfTile,
                Typical = m_typicalSizePx,
            }.Schedule(inputDeps);
        }

        // Makes the colours that ToImage takes, after all drawing.
        public JobHandle ScheduleResolve(ResolvePictureJob job, JobHandle inputDeps)
        {
            job.Pixels = m_pixels;
            job.Colors = m_colors;
            return job.ScheduleParallel(HeightPx, 16, inputDeps);
        }

        public RgbaImage ToImage()
        {
            var image = new RgbaImage(WidthPx / SamplesPerEdge, HeightPx / SamplesPerEdge);
            if (SamplesPerEdge == 1)
            {
                m_colors.Reinterpret<byte>(sizeof(uint)).CopyTo(image.Rgba);
                return image;
            }
            using var light = Drawing.Palettes.CreateSrgbToLinear(Allocator.TempJob);
            using var means = new NativeArray<uint>(image.Rgba.Length / sizeof(uint), Allocator.TempJob);
            new AverageSamplesJob
            {
                Samples = m_colors,
                SamplesPerEdge = SamplesPerEdge,
                LightOfByte = light,
                WidthPx = image.Width,
                Means = means,
            }.ScheduleParallel(image.Height, 16, default).Complete();
            means.Reinterpret<byte>(sizeof(uint)).CopyTo(image.Rgba);
            return image;
        }

        public void Dispose()
        {
            if (!m_pixels.IsCreated)
                return;
            m_pixels.Dispose();
            m_colors.Dispose();
            m_sizeOfTile.Dispose();
            Shadows?.Dispose();
            m_typicalSizePx.Dispose();
            m_palettes.Dispose();
        }
    }

    // The mean light of each pixel's samples, of which sRGB is no linear measure; that of their alpha as it is. Index i is row i.
    [BurstCompile]
    internal struct AverageSamplesJob : IJobFor
    {
        [ReadOnly] public NativeArray<uint> Samples;
        public int SamplesPerEdge;
        [ReadOnly] public NativeArray<float> LightOfByte;
        public int WidthPx;
        [NativeDisableParallelForRestriction, WriteOnly] public NativeArray<uint> Means;

        public void Execute(int index)
        {
            for (int x = 0; x < WidthPx; x++)
            {
                var light = float3.zero;
                uint alpha = 0;
                for (int y = 0; y < SamplesPerEdge; y++)
                    for (int i = 0; i < SamplesPerEdge; i++)
                    {
                        uint sample = Samples[(index * SamplesPerEdge + y) * WidthPx * SamplesPerEdge + x * SamplesPerEdge + i];
                        light += new float3(LightOfByte[(int)(sample & 255)], LightOfByte[(int)(sample >> 8 & 255)],
                            LightOfByte[(int)(sample >> 16 & 255)]);
                        alpha += sample >> 24;
                    }
                int count = SamplesPerEdge * SamplesPerEdge;
                light /= count;
                Means[index * WidthPx + x] = Drawing.Palettes.Pack(Encoded(light.x), Encoded(light.y), Encoded(light.z),
                    (byte)((alpha + count / 2) / count));
            }
        }

        static byte Encoded(float light) => (byte)(Drawing.Palettes.LinearToSrgb(light) * 255 + 0.5);
    }

    // Draws a range of a batch's points; index i is its i-th piece of PointsPerPiece points.
    [BurstCompile]
    internal struct RasterizePointsJob : IJobFor
    {
        public const int PointsPerPiece = 2048;

        [ReadOnly] public NativeArray<byte> Bytes;
        [ReadOnly] public NativeArray<uint> Palettes;
        [ReadOnly] public NativeArray<float> SizeOfTile;
        public PointDrawing Drawing;
        public int First;
        public int Count;

        // Written by atomic minimum, so that jobs on other batches may draw at the same time.
        [NativeDisableContainerSafetyRestriction] public NativeArray<ulong> Pixels;

        public static int PieceCount(int points) => (points + PointsPerPiece - 1) / PointsPerPiece;

        public unsafe void Execute(int index)
        {
            int start = index * PointsPerPiece;
            Drawing.Draw((byte*)Bytes.GetUnsafeReadOnlyPtr(), First + start, math.min(PointsPerPiece, Count - start),
                new PictureMemory(Palettes, SizeOfTile, Pixels));
        }
    }
}
