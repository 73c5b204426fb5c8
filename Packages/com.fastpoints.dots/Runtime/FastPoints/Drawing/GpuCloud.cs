using System.Runtime.InteropServices;
using FastPoints.Core;
using Unity.Mathematics;

namespace FastPoints.Drawing
{
    /// <summary>A cloud as shaders see it.</summary>
    [GenerateHlsl]
    [StructLayout(LayoutKind.Sequential)]
    internal struct GpuCloud
    {
        /// <summary>World vector of one grid step along the cloud's X.</summary>
        public float3 StepX;

        /// <summary>The value of <see cref="CloudLook.Source"/>.</summary>
        public uint ColorSource;
        public float3 StepY;

        /// <summary>Types of the colour plane's columns: bits 0-7, 8-15, 16-23; bits 24-31: number of the palette.</summary>
        public uint ColumnTypes;
        public float3 StepZ;

        /// <summary>Bits 0-7: columns of the colour plane; bit 8 + c: column c is of 64 bits.</summary>
        public uint Columns;

        /// <summary>Palette entries for one grid step.</summary>
        public float3 ValuePerStep;

        /// <summary>Added to the product of a value and its column's scale.</summary>
        public float Bias;

        /// <summary>For each column of the colour plane: palette entries, or 255ths of a channel, for one stored unit.</summary>
        public float3 Scale;

        /// <summary>Multiplies stored units to give classes.</summary>
        public uint ClassDivisor;

        /// <summary>The <see cref="ClassMask"/> of points that are not drawn.</summary>
        public uint4 HiddenLow;
        public uint4 HiddenHigh;
    }
}
