using System;
using System.Collections.Generic;
using System.Globalization;
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

        const float DefaultLitFraction = 0.7f;

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

        /// <summary>Keys that <see cref="TrySetStyle"/> takes, for a help text.</summary>
        public const string StyleHelp =
            "color=auto|rgb|elevation|intensity|classification|returnnumber|pointsource or an attribute's name, " +
            "gradient=auto|viridis|turbo|gray, size=auto|PIXELS|LENGTHu|adaptive[:GAPS], " +
            "points=square|round|paraboloid|splat (the last of converted clouds), " +
            "classes=N+N+... (shown; of converted clouds), edl=auto|on|off|STRENGTH, " +
            "light=auto|on|off|AZIMUTH,ELEVATION[,SHARE], shadows=on|off, holes=fill|keep, " +
            "background=RRGGBB[AA], up=x|y|z|-x|-y|-z";

        /// <summary>Sets one option from text, as for <c>--style</c>; the error says what was expected.</summary>
        public bool TrySetStyle(string key, string value, out string error)
        {
            error = null;
            float number;
            switch (key)
            {
                case "color":
                    ColorAttribute = null;
                    if (TryName(value, out Color, ref error) || value.Length == 0 || !char.IsLetter(value[0]))
                        return error == null;
                    (Color, ColorAttribute, error) = (ColorMode.Intensity, value, null);
                    ColorRamp = ColorRamp == ColorRamp.Auto ? ColorRamp.Viridis : ColorRamp;
                    return true;
                case "gradient":
                    return TryName(value, out ColorRamp, ref error);
                case "up":
                    GuessesUpAxis = false;
                    if (TryName(value.StartsWith("-") ? "Negative" + value.Substring(1) : value, out UpAxis, ref error))
                        return true;
                    error = "wanted x, y, z, -x, -y or -z, got " + value;
                    return false;
                case "size":
                    if (!TrySize(value))
                        error = "size: wanted auto, 1 to " + NumberText.Of(PointDrawing.MaxSizePx) +
                            " pixels, a length in units of the coordinates as in 0.05u, or adaptive, with distances " +
                            "between points as in adaptive:1.2; got " + value;
                    break;
                case "points":
                    if (value != "square" && value != "round" && value != "paraboloid" && value != "splat")
                        error = "points: wanted square, round, paraboloid or splat, got " + value;
                    RoundPoints = value == "round" || value == "splat";
                    BlendedPoints = value == "splat";
                    ParaboloidPoints = value == "paraboloid";
                    break;
                case "classes":
                    if (!TryClasses(value))
                        error = "classes: wanted numbers from 0 to 255 as in 2+6, got " + value;
                    break;
                case "edl":
                    if (value == "auto" || value == "on" || value == "off")
                        EdlStrength = value == "auto" ? -1 : value == "on" ? DefaultEdlStrength : 0;
                    else if (TryNumber(value, 0, 100, out number))
                        EdlStrength = number;
                    else
                        error = "edl: wanted auto, on, off or a strength, got " + value;
                    break;
                case "light":
                    if (!TryLight(value))
                        error = "light: wanted auto, on, off, or degrees from north and above the horizon and perhaps a " +
                            "share, as in 315,45,0.7; got " + value;
                    break;
                case "shadows":
                    if (value != "on" && value != "off")
                        error = "shadows: wanted on or off, got " + value;
                    Shadows = value == "on";
                    break;
                case "holes":
                    if (value != "fill" && value != "keep")
                        error = "holes: wanted fill or keep, got " + value;
                    FillsHoles = value == "fill";
                    break;
                case "background":
                    if (!TryColor(value, out Background))
                        error = "background: wanted RRGGBB or RRGGBBAA in hexadecimal, got " + value;
                    break;
                default:
                    error = "no such style: " + key + "; there are " + StyleHelp;
                    break;
            }
            return error == null;
        }

        static bool TryName<T>(string text, out T value, ref string error) where T : struct, Enum
        {
            if (text.Length > 0 && char.IsLetter(text[0]) && Enum.TryParse(text, true, out value))
                return true;
            value = default;
            error = "wanted " + string.Join(", ", Enum.GetNames(typeof(T))).ToLowerInvariant() + ", got " + text;
            return false;
        }

        static bool TryNumber(string text, float min, float max, out float value)
        {
            bool isNumber = NumberText.TryRead(text, out double number);
            value = (float)number;
            return isNumber && value >= min && value <= max;
        }

        bool TrySize(string value)
        {
            const string adaptive = "adaptive", ofGaps = adaptive + ":";
            float number = 0;
            PointSize? inWorld = null;
            if (value == adaptive)
                inWorld = PointSize.Adaptive();
            else if (value.StartsWith(ofGaps, StringComparison.Ordinal) &&
                TryNumber(value.Substring(ofGaps.Length), 0.01f, 100, out number))
                inWorld = PointSize.Adaptive(number);
            else if (value.EndsWith("u", StringComparison.Ordinal) &&
                TryNumber(value.Substring(0, value.Length - 1), float.Epsilon, float.MaxValue, out number))
                inWorld = PointSize.World(number);
            else if (value != "auto" && !TryNumber(value, 1, PointDrawing.MaxSizePx, out number))
                return false;
            SizeInWorld = inWorld;
            PointSizePx = inWorld.HasValue ? 0 : number;
            return true;
        }

        bool TryLight(string value)
        {
            LightAzimuth = double.NaN;
            LightElevation = 45;
            LitFraction = value == "auto" ? -1 : value == "off" ? 0 : DefaultLitFraction;
            if (value == "auto" || value == "off" || value == "on")
                return true;
            var parts = value.Split(',');
            if (parts.Length < 2 || parts.Length > 3 || !TryNumber(parts[0], -360, 360, out float azimuth) ||
                !TryNumber(parts[1], -90, 90, out float elevation))
                return false;
            LightAzimuth = azimuth;
            LightElevation = elevation;
            return parts.Length == 2 || TryNumber(parts[2], 0, 1, out LitFraction);
        }

        bool TryClasses(string value)
        {
            var shown = new ClassMask();
            foreach (string part in value.Split('+'))
            {
                if (!byte.TryParse(part, NumberStyles.None, CultureInfo.InvariantCulture, out byte c))
                    return false;
                shown.Add(c);
            }
            HiddenClasses = shown.Inverse;
            return true;
        }

        static bool TryColor(string text, out uint color)
        {
            string hex = text.TrimStart('#');
            color = 0;
            if (hex.Length == 6)
                hex += "FF";
            if (hex.Length != 8 || !uint.TryParse(hex, NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture,
                out uint value))
                return false;
            color = Palettes.Pack((byte)(value >> 24), (byte)(value >> 16), (byte)(value >> 8), (byte)value);
            return true;
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
