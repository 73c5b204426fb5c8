using Unity.Mathematics;

namespace FastPoints.Drawing
{
    /// <summary>How a cloud's points get their colours: the byte of a channel, or the entry of the palette, is floor(value *
    /// Scale + Bias), clamped to 0 to 255.</summary>
    public struct CloudLook
    {
        public ColorSource Source;

        /// <summary>Index among the streamed planes; ignored for <see cref="ColorSource.Position"/>.</summary>
        public int Plane;

        /// <summary>Factor for one unit of the attribute as stored in the file, before any divisor.</summary>
        public double Scale;
        public double Bias;

        /// <summary>For Position: palette entries for one CRS unit along each axis; Bias is the root corner's entry.</summary>
        public double3 ValuePerUnit;

        /// <summary>Number of the palette; the tables follow one another.</summary>
        public int Palette;

        /// <summary>Classes whose points are not drawn.</summary>
        public ClassMask HiddenClasses;

        /// <summary>Index of the classification among the streamed planes; used if classes are hidden.</summary>
        public int ClassPlane;

        /// <summary>How much of its colours is lit, from 0 (at no cost) to 1, in sevenths.</summary>
        public float Light;

        // Index of stored normals among the streamed planes; 0 where it is lit by depth.
        internal int NormalPlane;
        internal double3 Metres; // Of a unit, along the axes of stored normals.
    }

    /// <summary>What a point's colour is taken from.</summary>
    public enum ColorSource : uint
    {
        /// <summary>Three columns are red, green and blue.</summary>
        Channels,

        /// <summary>One column, looked up in the palette.</summary>
        Attribute,

        /// <summary>The same, with the palette repeated.</summary>
        Wrapped,

        /// <summary>The position, looked up in the palette.</summary>
        Position,
    }
}
