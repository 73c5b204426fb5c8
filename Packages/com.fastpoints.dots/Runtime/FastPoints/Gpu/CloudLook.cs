using Unity.Mathematics;

namespace FastPoints.Gpu
{
    /// <summary>How a cloud's points get their colours: byte of a channel, or entry of the palette, is
    /// floor(value * Scale + Bias), kept within 0 and 255.</summary>
    public struct CloudLook
    {
        public ColorSource Source;

        /// <summary>Counted among the planes that are streamed; not looked at for <see cref="ColorSource.Place"/>.</summary>
        public int Plane;

        /// <summary>For one unit of the attribute; of what stands in the file, before any divisor.</summary>
        public double Scale;
        public double Bias;

        /// <summary>For <see cref="ColorSource.Place"/>: entries of the palette for one CRS unit along each of the cloud's axes;
        /// <see cref="Bias"/> is then the root corner's entry.</summary>
        public double3 ValuePerUnit;

        /// <summary>Number of the palette: the tables lie one behind the other.</summary>
        public int Palette;

        /// <summary>Classes whose points are not drawn.</summary>
        public ClassMask HiddenClasses;

        /// <summary>The classification, counted among the planes that are streamed: looked at where classes are
        /// hidden.</summary>
        public int ClassPlane;
    }

    /// <summary>What a point's colour is taken from.</summary>
    public enum ColorSource : uint
    {
        /// <summary>Three columns are red, green and blue.</summary>
        Channels,

        /// <summary>One column, looked up in the palette.</summary>
        Attribute,

        /// <summary>The same, with entries of the palette used again and again.</summary>
        Wrapped,

        /// <summary>The place, looked up in the palette.</summary>
        Place,
    }
}
