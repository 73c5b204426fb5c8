using System.Collections.Generic;
using FastPoints.Points;

namespace FastPoints.Picture
{
    /// <summary>What each mode is taken from.</summary>
    public static class ColorModes
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
}
