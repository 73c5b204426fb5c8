using System.Collections.Generic;
using FastPoints.Drawing;
using FastPoints.Streaming;

namespace FastPoints.Picture
{
    /// <summary>Options of a picture.</summary>
    public sealed class PictureOptions
    {
        /// <summary>Strong enough to read shapes by, not so strong that noise shows.</summary>
        public const float DefaultEdlStrength = 0.25f;

        internal const double DefaultFovDegrees = 45;

        public int WidthPx = 1280;
        public int HeightPx = 720;
        internal int SamplesPerEdge = 1; // Along a pixel's edge: see PictureCanvas.

        /// <summary>Used if <see cref="Camera"/> is null.</summary>
        public ViewDirection View = ViewDirection.Auto;

        /// <summary>Replaces a standard view.</summary>
        public Camera? Camera;

        /// <summary>How many points of the framing sample a standard view is fitted to. All of them cost 10 ms.</summary>
        public int FramingPoints = int.MaxValue;

        public double FovDegrees = DefaultFovDegrees;
        public UpAxis UpAxis = UpAxis.Z;
        internal bool GuessesUpAxis; // A preview of a format that does not say what is up sets UpAxis: see UpAxisGuess.

        public ColorMode Color = ColorMode.Auto;

        /// <summary>The attribute that <see cref="ColorMode.Intensity"/> shows in place of the intensity; null for that. Only for
        /// pictures that are not streamed.</summary>
        public string ColorAttribute;

        public ColorRamp ColorRamp = ColorRamp.Auto;

        /// <summary>Size in pixels; 0 makes points as large as surfaces need to look closed.</summary>
        public float PointSizePx;

        /// <summary>Replaces PointSizePx. Only streamed clouds can be adaptive; for others that means 0.</summary>
        public PointSize? SizeInWorld;

        /// <summary>Whether sizes are chosen from a first picture of the points.</summary>
        public bool IsAutoSize => PointSizePx < 1 && SizeInWorld?.Mode != PointSizeMode.World;

        /// <summary>Streamed clouds do not draw points of these classes.</summary>
        public ClassMask HiddenClasses;

        /// <summary>The boxes that streamed clouds are clipped by, georeferenced.</summary>
        public readonly List<ClipBox> ClipBoxes = new List<ClipBox>();

        /// <summary>Whether some points are not drawn.</summary>
        public bool IsFiltered => ClipBoxes.Count > 0 || !HiddenClasses.IsEmpty;

        /// <summary>Draws discs instead of squares.</summary>
        public bool RoundPoints;

        /// <summary>Blends discs that lie behind one another, for streamed clouds: see <see cref="BlendedPixels"/>.</summary>
        public bool BlendedPoints;

        /// <summary>See <see cref="PointDrawing.IsParaboloid"/>.</summary>
        public bool ParaboloidPoints;

        /// <summary>Red, green, blue, alpha from the lowest byte.</summary>
        public uint Background = Palettes.Pack(24, 26, 30);

        /// <summary>Eye-dome lighting: 0 for none; negative for none with RGB and the default with other modes.</summary>
        public float EdlStrength = -1;

        /// <summary>The strength for a mode that is not <see cref="ColorMode.Auto"/>.</summary>
        public float EdlFor(ColorMode mode) => EdlStrength >= 0 ? EdlStrength : mode == ColorMode.Rgb ? 0 : DefaultEdlStrength;

        internal const float DefaultLitFraction = 0.7f;

        /// <summary>The share of the points' colours that is lit, 0 to 1; negative for none where they are the scanner's, or show
        /// an amount by grey, and 0.7 where clouds without colours show elevation or classes.</summary>
        public float LitFraction = -1;

        /// <summary>Where light comes from: degrees clockwise from north, and above the horizon. NaN for the camera's
        /// left.</summary>
        public double LightAzimuth = double.NaN;
        public double LightElevation = 45;

        /// <summary>Points shade each other from that light, which falls on them whatever they show.</summary>
        public bool Shadows;

        internal float LitFractionFor(ColorMode mode, ColorDepth color) => LitFraction >= 0 ? LitFraction
            : Shadows || color == ColorDepth.None && (mode == ColorMode.Elevation || mode == ColorMode.Classification)
                ? DefaultLitFraction : 0;

        /// <summary>See <see cref="ResolvePictureJob.FillsHoles"/>.</summary>
        public bool FillsHoles;

        // Read before a picture is planned.
        internal string[] AttributesToMeasure()
        {
            var names = new List<string>(ColorModes.AttributesToMeasure(Color));
            if (ColorAttribute != null)
                names.Add(ColorAttribute);
            return names.ToArray();
        }

        // The default is the intensity.
        internal DisplayRanges NewRanges(CloudUnits units)
        {
            var ranges = new DisplayRanges { Units = units };
            if (ColorAttribute != null)
                ranges.ValueAttribute = ColorAttribute;
            return ranges;
        }
    }

    /// <summary>Standard views; x is east, y north and z up for a cloud whose up axis is Z.</summary>
    public enum ViewDirection
    {
        /// <summary>Iso, or Front for a cloud that is a wall.</summary>
        Auto,
        /// <summary>Orthographic, from above, north at the top.</summary>
        Top,
        /// <summary>Orthographic, from the south.</summary>
        Front,
        /// <summary>Perspective, from the south-east and above.</summary>
        Iso,
        /// <summary>Orthographic, from the north.</summary>
        Back,
        /// <summary>Orthographic, from the west.</summary>
        Left,
        /// <summary>Orthographic, from the east.</summary>
        Right,
        /// <summary>Orthographic, from below, north at the top.</summary>
        Bottom,
    }
}
