using System.Runtime.InteropServices;
using FastPoints.Core;
using FastPoints.Streaming;
using Unity.Mathematics;

namespace FastPoints.Drawing
{
    // A clip box for one view: the dot product of a row's x, y, z with the vector from the camera, plus its w, is a coordinate
    // in the box, from -0.5 to 0.5.
    [GenerateHlsl]
    [StructLayout(LayoutKind.Sequential)]
    internal struct GpuClipBox
    {
        public float4 RowX;
        public float4 RowY;
        public float4 RowZ;

        public uint3 Reserved;

        // 1 if the box removes what lies inside it.
        public uint Cuts;

        public GpuClipBox(in ClipBox box, double3 eyeWorld)
        {
            var rows = math.transpose(math.inverse(box.EdgesWorld));
            var eye = eyeWorld - box.CenterWorld;
            RowX = (float4)new double4(rows.c0, math.dot(rows.c0, eye));
            RowY = (float4)new double4(rows.c1, math.dot(rows.c1, eye));
            RowZ = (float4)new double4(rows.c2, math.dot(rows.c2, eye));
            Cuts = box.Cuts ? 1u : 0u;
            Reserved = default;
        }
    }
}
