using System;
using System.Collections.Generic;
using FastPoints.Drawing;
using FastPoints.Store;
using FastPoints.Streaming;

namespace FastPoints.Rendering
{
    // Translates a picture's colours into shader parameters, so that both colour a point alike.
    internal static class CloudLooks
    {
        // Besides the position; normals of clouds that have some.
        public static string[] PlanesFor(ColorMode mode, bool hidesClasses, bool isLit)
        {
            var planes = new List<string>(PlanesFor(mode));
            if (hidesClasses && mode != ColorMode.Classification)
                planes.Add(AttributeNames.Classification);
            if (isLit)
                planes.Add(StoreLayout.NormalName);
            return planes.ToArray();
        }

        public static string[] PlanesFor(ColorMode mode) => mode == ColorMode.Rgb ? new[] { StoreLayout.ColorName }
            : ColorModes.AttributeOf(mode) is string attribute ? new[] { attribute } : new string[0];

        // Colours by position take grid steps from the corner of the source's root cube. The source streams the plane that the
        // mode needs; without a plane of classes, none is hidden.
        public static CloudLook Of(in ColorMapping colors, NodeSource source, in ClassMask hidden = default)
        {
            var look = new CloudLook { Scale = colors.Scale, Bias = colors.Bias, Palette = colors.FirstEntry / Palettes.Length };
            if (!hidden.IsEmpty && FindPlane(source, AttributeNames.Classification, out look.ClassPlane))
                look.HiddenClasses = hidden;
            if (FindPlane(source, StoreLayout.NormalName, out look.NormalPlane))
                look.Metres = source.Crs.Units.MetresAt(source.Grid.ToGeo(source.Root.Corner), UpAxis.Z);
            switch (colors.Mode)
            {
                case ColorMode.Rgb:
                    look.Source = ColorSource.Channels;
                    look.Plane = PlaneOf(source, StoreLayout.ColorName);
                    break;
                case ColorMode.Elevation:
                    look.Source = ColorSource.Position;
                    look.ValuePerUnit = colors.PositionWeights * colors.Scale / source.Grid.Step;
                    break;
                default:
                    look.Source = colors.Wraps ? ColorSource.Wrapped : ColorSource.Attribute;
                    look.Plane = PlaneOf(source, ColorModes.AttributeOf(colors.Mode));
                    break;
            }
            return look;
        }

        static int PlaneOf(NodeSource source, string name) => FindPlane(source, name, out int plane) ? plane
            : throw new ArgumentException(source.Path + ": plane " + name + " is not streamed", nameof(source));

        // Among the streamed planes; 0 if it is not streamed.
        static bool FindPlane(NodeSource source, string name, out int found)
        {
            int plane = source.Layout.PlaneOf(name);
            for (found = source.Planes.Length - 1; found > 0; found--)
                if (source.Planes[found] == plane)
                    return true;
            return false;
        }
    }
}
