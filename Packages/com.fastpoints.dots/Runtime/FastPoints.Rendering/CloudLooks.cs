using System;
using FastPoints.Gpu;
using FastPoints.Picture;
using FastPoints.Points;
using FastPoints.Store;
using FastPoints.Streaming;

namespace FastPoints.Rendering
{
    /// <summary>From what a picture decides to what shaders are told: both colour a point alike.</summary>
    public static class CloudLooks
    {
        /// <summary>What a mode streams beside the position.</summary>
        public static string[] PlanesFor(ColorMode mode) => mode == ColorMode.Rgb ? new[] { StoreLayout.ColorName }
            : mode == ColorMode.Intensity ? new[] { AttributeNames.Intensity }
            : mode == ColorMode.Classification ? new[] { AttributeNames.Classification }
            : new string[0];

        /// <param name="colors">Of places in grid steps from the corner of the source's root cube.</param>
        /// <param name="source">Streams the plane that the mode needs.</param>
        public static CloudLook Of(in ColorMapping colors, NodeSource source)
        {
            var look = new CloudLook { Scale = colors.Scale, Bias = colors.Bias };
            switch (colors.Mode)
            {
                case ColorMode.Rgb:
                    look.Source = ColorSource.Channels;
                    look.Plane = PlaneOf(source, StoreLayout.ColorName);
                    break;
                case ColorMode.Intensity:
                    look.Source = ColorSource.Attribute;
                    look.Plane = PlaneOf(source, AttributeNames.Intensity);
                    break;
                case ColorMode.Classification:
                    look.Source = ColorSource.Attribute;
                    look.Plane = PlaneOf(source, AttributeNames.Classification);
                    break;
                default:
                    look.Source = ColorSource.Place;
                    look.ValuePerUnit = colors.PositionWeights * colors.Scale / source.Grid.Step;
                    break;
            }
            return look;
        }

        static int PlaneOf(NodeSource source, string name)
        {
            int plane = source.Layout.PlaneOf(name);
            for (int p = 0; p < source.Planes.Length; p++)
                if (source.Planes[p] == plane)
                    return p;
            throw new ArgumentException(source.Path + ": plane " + name + " is not streamed", nameof(source));
        }
    }
}
