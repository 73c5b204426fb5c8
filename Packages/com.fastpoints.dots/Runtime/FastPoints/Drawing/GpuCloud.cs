using System.Runtime.InteropServices;
using FastPoints.Core;
using Unity.Mathematics;

namespace FastPoints.Drawing
{
    [GenerateHlsl]
    [StructLayout(LayoutKind.Sequential)]
    internal struct GpuCloud
    {
        // World vector of one grid step along the cloud's X.
        public float3 StepX;
        public uint ColorSource;
        public float3 StepY;

        // Types of the colour plane's columns: bits 0-7, 8-15, 16-23; bits 24-31: number of the palette.
        public uint ColumnTypes;
        public float3 StepZ;

        // Bits 0-7: columns of the colour plane; bit 8 + c: column c is of 64 bits.
        public uint Columns;

        // Palette entries for one grid step.
        public float3 ValuePerStep;

        // Added to the product of a value and its column's scale.
        public float Bias;

        // For each column of the colour plane: palette entries, or 255ths of a channel, for one stored unit.
        public float3 Scale;

        // Multiplies stored units to give classes.
        public uint ClassDivisor;

        // The ClassMask of points that are not drawn.
        public uint4 HiddenLow;
        public uint4 HiddenHigh;
    }
}
