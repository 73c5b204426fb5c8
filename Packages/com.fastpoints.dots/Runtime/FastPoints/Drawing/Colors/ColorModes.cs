using System.Collections.Generic;

namespace FastPoints.Drawing
{
    internal static class ColorModes
    {
        // Modes whose values are names rather than amounts: there is nothing to measure.
        public static readonly IReadOnlyList<ColorMode> Categories = new[]
        {
            ColorMode.Classification, ColorMode.ReturnNumber, ColorMode.PointSource,
        };

        // The one attribute that a mode looks its colours up by; null for the others.
        public static string AttributeOf(ColorMode mode) => mode switch
        {
            ColorMode.Intensity => AttributeNames.Intensity,
            ColorMode.Classification => AttributeNames.Classification,
            ColorMode.ReturnNumber => AttributeNames.ReturnNumber,
            ColorMode.PointSource => AttributeNames.PointSourceId,
            _ => null,
        };

        // Read before a mode can be chosen: colour, intensity, classes, and whatever else the wanted mode needs.
        public static string[] AttributesToMeasure(ColorMode wanted)
        {
            var names = new List<string>
            {
                AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue, AttributeNames.Intensity,
                AttributeNames.Classification,
            };
            if (AttributeOf(wanted) is string name && !names.Contains(name))
                names.Add(name);
            return names.ToArray();
        }
    }

    /// <summary>What the colour of a point shows.</summary>
    public enum ColorMode
    {
        /// <summary>RGB if there is any and it is not all black, else classes where they are set, else elevation.</summary>
        Auto,
        /// <summary>The point's own colour: its sRGB values as they are, or the upper eight of sixteen bits.</summary>
        Rgb,
        /// <summary>Height along the up axis, on a perceptually even ramp.</summary>
        Elevation,
        /// <summary>Grey, with light in proportion to the stored intensity.</summary>
        Intensity,
        /// <summary>One colour for each class.</summary>
        Classification,
        /// <summary>One colour for each number: the first return, the second and so on. Only for converted clouds.</summary>
        ReturnNumber,
        /// <summary>One colour for each flight line or scanner: 256 colours that repeat. Only for converted clouds.</summary>
        PointSource,
    }

    /// <summary>How a cloud's colour values are scaled: decided once, from a whole sample.</summary>
    public enum ColorDepth
    {
        /// <summary>There is no colour, or nothing but black.</summary>
        None,
        /// <summary>0 to 255, whatever the type.</summary>
        Bits8,
        /// <summary>0 to 65,535.</summary>
        Bits16,
        /// <summary>0 to 1.</summary>
        Unit,
    }
}
