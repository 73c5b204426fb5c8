using System.Collections.Generic;
using FastPoints.Points;

namespace FastPoints.Picture
{
    /// <summary>What each mode is taken from.</summary>
    internal static class ColorModes
    {
        /// <summary>Modes of values that are names rather than amounts: there is nothing to measure of them.</summary>
        public static readonly IReadOnlyList<ColorMode> Categories = new[]
        {
            ColorMode.Classification, ColorMode.ReturnNumber, ColorMode.PointSource,
        };

        /// <summary>The one attribute that a mode looks its colours up by; null for the others.</summary>
        public static string AttributeOf(ColorMode mode)
        {
            switch (mode)
            {
                case ColorMode.Intensity:
                    return AttributeNames.Intensity;
                case ColorMode.Classification:
                    return AttributeNames.Classification;
                case ColorMode.ReturnNumber:
                    return AttributeNames.ReturnNumber;
                case ColorMode.PointSource:
                    return AttributeNames.PointSourceId;
                default:
                    return null;
            }
        }

        /// <summary>What must be read before it is known which mode will do: colour, intensity, classes, and what the mode that
        /// is asked for wants beside.</summary>
        public static string[] AttributesToMeasure(ColorMode wanted)
        {
            var names = new List<string>
            {
                AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue, AttributeNames.Intensity, AttributeNames.Classification,
            };
            if (AttributeOf(wanted) is string name && !names.Contains(name))
                names.Add(name);
            return names.ToArray();
        }
    }

    /// <summary>What the colour of a point says.</summary>
    public enum ColorMode
    {
        /// <summary>RGB where it is there and not black, else intensity where it varies, else elevation.</summary>
        Auto,
        /// <summary>The point's own colour: its sRGB values as they are, the upper eight of sixteen bits.</summary>
        Rgb,
        /// <summary>Height along the up axis, on a ramp even to the eye.</summary>
        Elevation,
        /// <summary>Grey; light in proportion to the stored intensity.</summary>
        Intensity,
        /// <summary>One colour for each class.</summary>
        Classification,
        /// <summary>One colour for each number: the first return, the second and so on. Of converted clouds.</summary>
        ReturnNumber,
        /// <summary>One colour for each flight line or scanner: 256, used again and again. Of converted clouds.</summary>
        PointSource,
    }

    /// <summary>How a cloud's colour values are to be read: decided once, from all of a sample.</summary>
    public enum ColorDepth
    {
        /// <summary>No colour, or nothing but black.</summary>
        None,
        /// <summary>0 to 255, whatever the type.</summary>
        Bits8,
        /// <summary>0 to 65,535.</summary>
        Bits16,
        /// <summary>0 to 1.</summary>
        Unit,
    }
}
