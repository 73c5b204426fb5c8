using System.Runtime.InteropServices;
using FastPoints.Base;
using Unity.Mathematics;

namespace FastPoints.Gpu
{
    /// <summary>A cloud as shaders see it.</summary>
    [GenerateHlsl]
    [StructLayout(LayoutKind.Sequential)]
    internal struct GpuCloud
    {
        /// <summary>World vector of one grid step along the cloud's X.</summary>
        public float3 StepX;

        /// <summary>What <see cref="CloudLook.Source"/> is.</summary>
        public uint ColorSource;
        public float3 StepY;

        /// <summary>Types of the colour plane's columns: bits 0-7, 8-15, 16-23; bits 24-31: number of the palette.</summary>
        public uint ColumnTypes;
        public float3 StepZ;

        /// <summary>Bits 0-7: columns of the colour plane; bit 8 + c: column c is of 64 bits.</summary>
        public uint Columns;

        /// <summary>Entries of the palette for one grid step.</summary>
        public float3 ValuePerStep;

        /// <summary>Added to a value times its column's scale.</summary>
        public float Bias;

        /// <summary>By column of the colour plane: entries of the palette, or 255ths of a channel, for one stored unit.</summary>
        public float3 Scale;

        /// <summary>A class for one stored unit.</summary>
        public uint ClassDivisor;

        /// <summary>See <see cref="ClassMask"/>: points that are not drawn.</summary>
        public uint4 HiddenLow;
        public uint4 HiddenHigh;
    }
}
