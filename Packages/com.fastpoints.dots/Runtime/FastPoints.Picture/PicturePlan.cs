using System;
using System.Collections.Generic;
using FastPoints.Drawing;
using FastPoints.Streaming;
using Unity.Mathematics;

namespace FastPoints.Picture
{
    // A picture's options resolved for one cloud, from the ranges of a sample, before a point is drawn.
    internal sealed class PicturePlan
    {
        readonly PositionTransform m_transform;

        public PicturePlan(PictureOptions options, DisplayRanges ranges, PositionTransform transform)
        {
            Options = options;
            Ranges = ranges;
            m_transform = transform;
            Mode = ranges.Resolve(options.Color);
            EdlStrength = options.EdlFor(Mode);
            LitLevel = PointLighting.LitLevelOf(options.LitFractionFor(Mode, ranges.Color));
            SizePx = options.PointSizePx >= 1 ? Math.Min(options.PointSizePx, PointDrawing.MaxSizePx) : PointSizing.MinPx;
            Camera = options.Camera ?? CameraFraming.Frame(options, ranges.Robust,
                Thinned(ranges.FramingSample, options.FramingPoints), ranges.ExtremePoints, ranges.LengthsPerUnit);
            Light = LightOf(options, Camera, ranges.LengthsPerUnit);
            Assumptions = new List<string>(ranges.Assumptions);
            if (options.Color == ColorMode.Auto)
                Assumptions.Add("coloured by " + Mode.ToString().ToLowerInvariant());
            else if (options.Color != Mode)
                Assumptions.Add("no " + options.Color.ToString().ToLowerInvariant() + " to colour by: coloured by " +
                    Mode.ToString().ToLowerInvariant());
        }

        public Camera Camera { get; }

        public ColorMode Mode { get; } // Never Auto.

        public PictureOptions Options { get; }
        public DisplayRanges Ranges { get; }
        public float EdlStrength { get; }
        public int LitLevel { get; } // Of PointLighting.MaxLitLevel.
        public PointLighting Light { get; set; }
        public ColorRamp ColorRamp => Options.ColorRamp;

        public ClassMask HiddenClasses => Options.HiddenClasses;

        public float SizePx { get; set; } // With automatic sizes, the size of the median tile.

        public bool UsesAutoSize => Options.IsAutoSize; // SizePx is still to be found from a picture of the sample.

        public List<string> Assumptions { get; }

        // Independent of a batch's columns.
        public ColorMapping Colors => ColorMapping.Of(Mode, Ranges, m_transform, ColorRamp);

        public PointDrawing DrawingOf(PointBatch batch, PictureCanvas canvas)
        {
            var world = Options.SizeInWorld.GetValueOrDefault();
            world.MaxPx *= canvas.SamplesPerEdge;
            bool isWorldSize = world.Mode == PointSizeMode.World;
            var lengths = Ranges.LengthsPerUnit;
            // Shadows are of what a layer has: with them, light is by its depths.
            var axes = new double3x3(Camera.Right / lengths, Camera.Up / lengths, Camera.Forward / lengths);
            var normals = new PointNormals(batch, Options.Shadows ? 0 : LitLevel, Light.RelativeTo(Camera.EyeGeo))
            {
                ToLight = double3x3.identity,
                ViewToLight = axes,
                ToView = math.transpose(axes),
            };
            return new PointDrawing
            {
                Positions = PositionColumns.Of(batch),
                Projection = new PointProjection(Camera, m_transform, canvas.WidthPx, canvas.HeightPx),
                Colors = ColorMapping.For(Mode, Ranges, batch, m_transform, ColorRamp),
                MaxTileSizePx = isWorldSize ? world.MaxPx : canvas.MaxTileSizePx,
                IsWorldSize = isWorldSize,
                Size = world,
                LitLevel = normals.LitLevel > 0 ? 0 : LitLevel,
                Normals = normals,
                IsRound = Options.RoundPoints,
                IsParaboloid = Options.ParaboloidPoints,
            };
        }

        public PointDrawing ShadowDrawingOf(PointBatch batch, PictureCanvas canvas)
        {
            var drawing = DrawingOf(batch, canvas.Shadows);
            drawing.Projection = new PointProjection(ShadowMap.CameraOf(canvas.ShadowMapProjection), m_transform,
                ShadowMapProjection.EdgePx,
                ShadowMapProjection.EdgePx);
            (drawing.IsWorldSize, drawing.MaxTileSizePx) = (false, 1);
            return drawing;
        }

        public ShadowMapProjection NewShadowFrame() => new ShadowMapProjection(Light.Direction, Ranges.LengthsPerUnit);

        // Around what the picture's own camera sees.
        public ShadowMapProjection ShadowFrameOfPicture()
        {
            if (!Options.Shadows)
                return default;
            var frame = NewShadowFrame();
            var bounds = Ranges.Robust;
            frame.Add(Camera.ToStreamView(Options.WidthPx, Options.HeightPx),
                new CloudPlacement(double3x3.identity, bounds.Center), 0, bounds.Size / 2);
            frame.Fit();
            return frame;
        }

        public ResolvePictureJob ResolveFor(in Camera camera, PictureCanvas canvas) => new ResolvePictureJob
        {
            Projection = new PointProjection(camera, PositionTransform.Identity, canvas.WidthPx, canvas.HeightPx),
            Background = Options.Background,
            EdlStrength = EdlStrength,
            Light = Light.RelativeTo(camera.EyeGeo),
            Shadows = canvas.ShadowMapFor(camera.EyeGeo),
            PixelPositions = PixelPositionsFor(camera, canvas.WidthPx, canvas.HeightPx),
            FillsHoles = Options.FillsHoles,
        };

        public PixelPositions PixelPositionsFor(in Camera camera, int widthPx, int heightPx)
        {
            var lengths = Ranges.LengthsPerUnit;
            double scale = new PointProjection(camera, m_transform, widthPx, heightPx).ScalePx;
            double3 right = camera.Right / lengths / scale, up = camera.Up / lengths / scale;
            return new PixelPositions
            {
                First = (float3)(up * ((heightPx - 1) * 0.5) - right * ((widthPx - 1) * 0.5)),
                StepX = (float3)right,
                StepY = (float3)(-up),
                Forward = (float3)(camera.Forward / lengths),
                IsOrthographic = camera.IsOrthographic,
            };
        }

        // Where no azimuth is asked for, from the left and above, so that the sides that the camera sees differ: from behind
        // it, but of maps from their upper left corner, as their shading is used to.
        static PointLighting LightOf(PictureOptions options, in Camera camera, double3 lengths)
        {
            options.UpAxis.Directions(out var east, out var north, out var up);
            double3 left = -camera.Right / lengths, back = -camera.Forward / lengths;
            back -= up * math.dot(back, up);
            double azimuth = math.radians(options.LightAzimuth), elevation = math.radians(options.LightElevation);
            var from = !double.IsNaN(azimuth) ? math.sin(azimuth) * east + math.cos(azimuth) * north
                : math.length(back) > 0.3 ? math.normalize(left + 0.6 * math.normalize(back))
                : math.normalize(left + camera.Up / lengths);
            return PointLighting.Default(
                (float3)math.normalize(math.cos(elevation) * from + math.sin(elevation) * up), (float3)up);
        }

        static double3[] Thinned(double3[] outline, int max)
        {
            if (outline.Length <= max)
                return outline;
            var thinned = new double3[max];
            for (int i = 0; i < max; i++)
                thinned[i] = outline[(int)((long)i * outline.Length / max)];
            return thinned;
        }
    }
}
