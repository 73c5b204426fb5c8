// A plain reading of Unity's signatures, one line a component.
using System.Runtime.CompilerServices;

namespace Unity.Mathematics
{
    public static partial class math
    {
        [MethodImpl(Inlining.Always)]
        public static bool2 bool2(bool v) => new bool2(v);

        [MethodImpl(Inlining.Always)]
        public static bool2 bool2(bool x, bool y) => new bool2(x, y);

        [MethodImpl(Inlining.Always)]
        public static bool2 bool2(bool2 xy) => new bool2(xy);

        [MethodImpl(Inlining.Always)]
        public static bool3 bool3(bool v) => new bool3(v);

        [MethodImpl(Inlining.Always)]
        public static bool3 bool3(bool x, bool y, bool z) => new bool3(x, y, z);

        [MethodImpl(Inlining.Always)]
        public static bool3 bool3(bool x, bool2 yz) => new bool3(x, yz);

        [MethodImpl(Inlining.Always)]
        public static bool3 bool3(bool2 xy, bool z) => new bool3(xy, z);

        [MethodImpl(Inlining.Always)]
        public static bool3 bool3(bool3 xyz) => new bool3(xyz);

        [MethodImpl(Inlining.Always)]
        public static bool4 bool4(bool v) => new bool4(v);

        [MethodImpl(Inlining.Always)]
        public static bool4 bool4(bool x, bool y, bool z, bool w) => new bool4(x, y, z, w);

        [MethodImpl(Inlining.Always)]
        public static bool4 bool4(bool x, bool y, bool2 zw) => new bool4(x, y, zw);

        [MethodImpl(Inlining.Always)]
        public static bool4 bool4(bool x, bool2 yz, bool w) => new bool4(x, yz, w);

        [MethodImpl(Inlining.Always)]
        public static bool4 bool4(bool x, bool3 yzw) => new bool4(x, yzw);

        [MethodImpl(Inlining.Always)]
        public static bool4 bool4(bool2 xy, bool z, bool w) => new bool4(xy, z, w);

        [MethodImpl(Inlining.Always)]
        public static bool4 bool4(bool2 xy, bool2 zw) => new bool4(xy, zw);

        [MethodImpl(Inlining.Always)]
        public static bool4 bool4(bool3 xyz, bool w) => new bool4(xyz, w);

        [MethodImpl(Inlining.Always)]
        public static bool4 bool4(bool4 xyzw) => new bool4(xyzw);

        [MethodImpl(Inlining.Always)]
        public static int2 int2(bool v) => new int2(v);

        [MethodImpl(Inlining.Always)]
        public static int2 int2(double v) => new int2(v);

        [MethodImpl(Inlining.Always)]
        public static int2 int2(int v) => new int2(v);

        [MethodImpl(Inlining.Always)]
        public static int2 int2(int x, int y) => new int2(x, y);

        [MethodImpl(Inlining.Always)]
        public static int2 int2(float v) => new int2(v);

        [MethodImpl(Inlining.Always)]
        public static int2 int2(uint v) => new int2(v);

        [MethodImpl(Inlining.Always)]
        public static int2 int2(bool2 v) => new int2(v);

        [MethodImpl(Inlining.Always)]
        public static int2 int2(double2 v) => new int2(v);

        [MethodImpl(Inlining.Always)]
        public static int2 int2(float2 v) => new int2(v);

        [MethodImpl(Inlining.Always)]
        public static int2 int2(int2 xy) => new int2(xy);

        [MethodImpl(Inlining.Always)]
        public static int2 int2(uint2 v) => new int2(v);

        [MethodImpl(Inlining.Always)]
        public static int3 int3(bool v) => new int3(v);

        [MethodImpl(Inlining.Always)]
        public static int3 int3(double v) => new int3(v);

        [MethodImpl(Inlining.Always)]
        public static int3 int3(int v) => new int3(v);

        [MethodImpl(Inlining.Always)]
        public static int3 int3(int x, int y, int z) => new int3(x, y, z);

        [MethodImpl(Inlining.Always)]
        public static int3 int3(int x, int2 yz) => new int3(x, yz);

        [MethodImpl(Inlining.Always)]
        public static int3 int3(float v) => new int3(v);

        [MethodImpl(Inlining.Always)]
        public static int3 int3(uint v) => new int3(v);

        [MethodImpl(Inlining.Always)]
        public static int3 int3(bool3 v) => new int3(v);

        [MethodImpl(Inlining.Always)]
        public static int3 int3(double3 v) => new int3(v);

        [MethodImpl(Inlining.Always)]
        public static int3 int3(float3 v) => new int3(v);

        [MethodImpl(Inlining.Always)]
        public static int3 int3(int2 xy, int z) => new int3(xy, z);

        [MethodImpl(Inlining.Always)]
        public static int3 int3(int3 xyz) => new int3(xyz);

        [MethodImpl(Inlining.Always)]
        public static int3 int3(uint3 v) => new int3(v);

        [MethodImpl(Inlining.Always)]
        public static int4 int4(bool v) => new int4(v);

        [MethodImpl(Inlining.Always)]
        public static int4 int4(double v) => new int4(v);

        [MethodImpl(Inlining.Always)]
        public static int4 int4(int v) => new int4(v);

        [MethodImpl(Inlining.Always)]
        public static int4 int4(int x, int y, int z, int w) => new int4(x, y, z, w);

        [MethodImpl(Inlining.Always)]
        public static int4 int4(int x, int y, int2 zw) => new int4(x, y, zw);

        [MethodImpl(Inlining.Always)]
        public static int4 int4(int x, int2 yz, int w) => new int4(x, yz, w);

        [MethodImpl(Inlining.Always)]
        public static int4 int4(int x, int3 yzw) => new int4(x, yzw);

        [MethodImpl(Inlining.Always)]
        public static int4 int4(float v) => new int4(v);

        [MethodImpl(Inlining.Always)]
        public static int4 int4(uint v) => new int4(v);

        [MethodImpl(Inlining.Always)]
        public static int4 int4(bool4 v) => new int4(v);

        [MethodImpl(Inlining.Always)]
        public static int4 int4(double4 v) => new int4(v);

        [MethodImpl(Inlining.Always)]
        public static int4 int4(float4 v) => new int4(v);

        [MethodImpl(Inlining.Always)]
        public static int4 int4(int2 xy, int z, int w) => new int4(xy, z, w);

        [MethodImpl(Inlining.Always)]
        public static int4 int4(int2 xy, int2 zw) => new int4(xy, zw);

        [MethodImpl(Inlining.Always)]
        public static int4 int4(int3 xyz, int w) => new int4(xyz, w);

        [MethodImpl(Inlining.Always)]
        public static int4 int4(int4 xyzw) => new int4(xyzw);

        [MethodImpl(Inlining.Always)]
        public static int4 int4(uint4 v) => new int4(v);

        [MethodImpl(Inlining.Always)]
        public static uint2 uint2(bool v) => new uint2(v);

        [MethodImpl(Inlining.Always)]
        public static uint2 uint2(double v) => new uint2(v);

        [MethodImpl(Inlining.Always)]
        public static uint2 uint2(int v) => new uint2(v);

        [MethodImpl(Inlining.Always)]
        public static uint2 uint2(float v) => new uint2(v);

        [MethodImpl(Inlining.Always)]
        public static uint2 uint2(uint v) => new uint2(v);

        [MethodImpl(Inlining.Always)]
        public static uint2 uint2(uint x, uint y) => new uint2(x, y);

        [MethodImpl(Inlining.Always)]
        public static uint2 uint2(bool2 v) => new uint2(v);

        [MethodImpl(Inlining.Always)]
        public static uint2 uint2(double2 v) => new uint2(v);

        [MethodImpl(Inlining.Always)]
        public static uint2 uint2(float2 v) => new uint2(v);

        [MethodImpl(Inlining.Always)]
        public static uint2 uint2(int2 v) => new uint2(v);

        [MethodImpl(Inlining.Always)]
        public static uint2 uint2(uint2 xy) => new uint2(xy);

        [MethodImpl(Inlining.Always)]
        public static uint3 uint3(bool v) => new uint3(v);

        [MethodImpl(Inlining.Always)]
        public static uint3 uint3(double v) => new uint3(v);

        [MethodImpl(Inlining.Always)]
        public static uint3 uint3(int v) => new uint3(v);

        [MethodImpl(Inlining.Always)]
        public static uint3 uint3(float v) => new uint3(v);

        [MethodImpl(Inlining.Always)]
        public static uint3 uint3(uint v) => new uint3(v);

        [MethodImpl(Inlining.Always)]
        public static uint3 uint3(uint x, uint y, uint z) => new uint3(x, y, z);

        [MethodImpl(Inlining.Always)]
        public static uint3 uint3(uint x, uint2 yz) => new uint3(x, yz);

        [MethodImpl(Inlining.Always)]
        public static uint3 uint3(bool3 v) => new uint3(v);

        [MethodImpl(Inlining.Always)]
        public static uint3 uint3(double3 v) => new uint3(v);

        [MethodImpl(Inlining.Always)]
        public static uint3 uint3(float3 v) => new uint3(v);

        [MethodImpl(Inlining.Always)]
        public static uint3 uint3(int3 v) => new uint3(v);

        [MethodImpl(Inlining.Always)]
        public static uint3 uint3(uint2 xy, uint z) => new uint3(xy, z);

        [MethodImpl(Inlining.Always)]
        public static uint3 uint3(uint3 xyz) => new uint3(xyz);

        [MethodImpl(Inlining.Always)]
        public static uint4 uint4(bool v) => new uint4(v);

        [MethodImpl(Inlining.Always)]
        public static uint4 uint4(double v) => new uint4(v);

        [MethodImpl(Inlining.Always)]
        public static uint4 uint4(int v) => new uint4(v);

        [MethodImpl(Inlining.Always)]
        public static uint4 uint4(float v) => new uint4(v);

        [MethodImpl(Inlining.Always)]
        public static uint4 uint4(uint v) => new uint4(v);

        [MethodImpl(Inlining.Always)]
        public static uint4 uint4(uint x, uint y, uint z, uint w) => new uint4(x, y, z, w);

        [MethodImpl(Inlining.Always)]
        public static uint4 uint4(uint x, uint y, uint2 zw) => new uint4(x, y, zw);

        [MethodImpl(Inlining.Always)]
        public static uint4 uint4(uint x, uint2 yz, uint w) => new uint4(x, yz, w);

        [MethodImpl(Inlining.Always)]
        public static uint4 uint4(uint x, uint3 yzw) => new uint4(x, yzw);

        [MethodImpl(Inlining.Always)]
        public static uint4 uint4(bool4 v) => new uint4(v);

        [MethodImpl(Inlining.Always)]
        public static uint4 uint4(double4 v) => new uint4(v);

        [MethodImpl(Inlining.Always)]
        public static uint4 uint4(float4 v) => new uint4(v);

        [MethodImpl(Inlining.Always)]
        public static uint4 uint4(int4 v) => new uint4(v);

        [MethodImpl(Inlining.Always)]
        public static uint4 uint4(uint2 xy, uint z, uint w) => new uint4(xy, z, w);

        [MethodImpl(Inlining.Always)]
        public static uint4 uint4(uint2 xy, uint2 zw) => new uint4(xy, zw);

        [MethodImpl(Inlining.Always)]
        public static uint4 uint4(uint3 xyz, uint w) => new uint4(xyz, w);

        [MethodImpl(Inlining.Always)]
        public static uint4 uint4(uint4 xyzw) => new uint4(xyzw);

        [MethodImpl(Inlining.Always)]
        public static float2 float2(bool v) => new float2(v);

        [MethodImpl(Inlining.Always)]
        public static float2 float2(double v) => new float2(v);

        [MethodImpl(Inlining.Always)]
        public static float2 float2(int v) => new float2(v);

        [MethodImpl(Inlining.Always)]
        public static float2 float2(float v) => new float2(v);

        [MethodImpl(Inlining.Always)]
        public static float2 float2(float x, float y) => new float2(x, y);

        [MethodImpl(Inlining.Always)]
        public static float2 float2(uint v) => new float2(v);

        [MethodImpl(Inlining.Always)]
        public static float2 float2(bool2 v) => new float2(v);

        [MethodImpl(Inlining.Always)]
        public static float2 float2(double2 v) => new float2(v);

        [MethodImpl(Inlining.Always)]
        public static float2 float2(float2 xy) => new float2(xy);

        [MethodImpl(Inlining.Always)]
        public static float2 float2(int2 v) => new float2(v);

        [MethodImpl(Inlining.Always)]
        public static float2 float2(uint2 v) => new float2(v);

        [MethodImpl(Inlining.Always)]
        public static float3 float3(bool v) => new float3(v);

        [MethodImpl(Inlining.Always)]
        public static float3 float3(double v) => new float3(v);

        [MethodImpl(Inlining.Always)]
        public static float3 float3(int v) => new float3(v);

        [MethodImpl(Inlining.Always)]
        public static float3 float3(float v) => new float3(v);

        [MethodImpl(Inlining.Always)]
        public static float3 float3(float x, float y, float z) => new float3(x, y, z);

        [MethodImpl(Inlining.Always)]
        public static float3 float3(float x, float2 yz) => new float3(x, yz);

        [MethodImpl(Inlining.Always)]
        public static float3 float3(uint v) => new float3(v);

        [MethodImpl(Inlining.Always)]
        public static float3 float3(bool3 v) => new float3(v);

        [MethodImpl(Inlining.Always)]
        public static float3 float3(double3 v) => new float3(v);

        [MethodImpl(Inlining.Always)]
        public static float3 float3(float2 xy, float z) => new float3(xy, z);

        [MethodImpl(Inlining.Always)]
        public static float3 float3(float3 xyz) => new float3(xyz);

        [MethodImpl(Inlining.Always)]
        public static float3 float3(int3 v) => new float3(v);

        [MethodImpl(Inlining.Always)]
        public static float3 float3(uint3 v) => new float3(v);

        [MethodImpl(Inlining.Always)]
        public static float4 float4(bool v) => new float4(v);

        [MethodImpl(Inlining.Always)]
        public static float4 float4(double v) => new float4(v);

        [MethodImpl(Inlining.Always)]
        public static float4 float4(int v) => new float4(v);

        [MethodImpl(Inlining.Always)]
        public static float4 float4(float v) => new float4(v);

        [MethodImpl(Inlining.Always)]
        public static float4 float4(float x, float y, float z, float w) => new float4(x, y, z, w);

        [MethodImpl(Inlining.Always)]
        public static float4 float4(float x, float y, float2 zw) => new float4(x, y, zw);

        [MethodImpl(Inlining.Always)]
        public static float4 float4(float x, float2 yz, float w) => new float4(x, yz, w);

        [MethodImpl(Inlining.Always)]
        public static float4 float4(float x, float3 yzw) => new float4(x, yzw);

        [MethodImpl(Inlining.Always)]
        public static float4 float4(uint v) => new float4(v);

        [MethodImpl(Inlining.Always)]
        public static float4 float4(bool4 v) => new float4(v);

        [MethodImpl(Inlining.Always)]
        public static float4 float4(double4 v) => new float4(v);

        [MethodImpl(Inlining.Always)]
        public static float4 float4(float2 xy, float z, float w) => new float4(xy, z, w);

        [MethodImpl(Inlining.Always)]
        public static float4 float4(float2 xy, float2 zw) => new float4(xy, zw);

        [MethodImpl(Inlining.Always)]
        public static float4 float4(float3 xyz, float w) => new float4(xyz, w);

        [MethodImpl(Inlining.Always)]
        public static float4 float4(float4 xyzw) => new float4(xyzw);

        [MethodImpl(Inlining.Always)]
        public static float4 float4(int4 v) => new float4(v);

        [MethodImpl(Inlining.Always)]
        public static float4 float4(uint4 v) => new float4(v);

        [MethodImpl(Inlining.Always)]
        public static double2 double2(bool v) => new double2(v);

        [MethodImpl(Inlining.Always)]
        public static double2 double2(double v) => new double2(v);

        [MethodImpl(Inlining.Always)]
        public static double2 double2(double x, double y) => new double2(x, y);

        [MethodImpl(Inlining.Always)]
        public static double2 double2(int v) => new double2(v);

        [MethodImpl(Inlining.Always)]
        public static double2 double2(float v) => new double2(v);

        [MethodImpl(Inlining.Always)]
        public static double2 double2(uint v) => new double2(v);

        [MethodImpl(Inlining.Always)]
        public static double2 double2(bool2 v) => new double2(v);

        [MethodImpl(Inlining.Always)]
        public static double2 double2(double2 xy) => new double2(xy);

        [MethodImpl(Inlining.Always)]
        public static double2 double2(float2 v) => new double2(v);

        [MethodImpl(Inlining.Always)]
        public static double2 double2(int2 v) => new double2(v);

        [MethodImpl(Inlining.Always)]
        public static double2 double2(uint2 v) => new double2(v);

        [MethodImpl(Inlining.Always)]
        public static double3 double3(bool v) => new double3(v);

        [MethodImpl(Inlining.Always)]
        public static double3 double3(double v) => new double3(v);

        [MethodImpl(Inlining.Always)]
        public static double3 double3(double x, double y, double z) => new double3(x, y, z);

        [MethodImpl(Inlining.Always)]
        public static double3 double3(double x, double2 yz) => new double3(x, yz);

        [MethodImpl(Inlining.Always)]
        public static double3 double3(int v) => new double3(v);

        [MethodImpl(Inlining.Always)]
        public static double3 double3(float v) => new double3(v);

        [MethodImpl(Inlining.Always)]
        public static double3 double3(uint v) => new double3(v);

        [MethodImpl(Inlining.Always)]
        public static double3 double3(bool3 v) => new double3(v);

        [MethodImpl(Inlining.Always)]
        public static double3 double3(double2 xy, double z) => new double3(xy, z);

        [MethodImpl(Inlining.Always)]
        public static double3 double3(double3 xyz) => new double3(xyz);

        [MethodImpl(Inlining.Always)]
        public static double3 double3(float3 v) => new double3(v);

        [MethodImpl(Inlining.Always)]
        public static double3 double3(int3 v) => new double3(v);

        [MethodImpl(Inlining.Always)]
        public static double3 double3(uint3 v) => new double3(v);

        [MethodImpl(Inlining.Always)]
        public static double4 double4(bool v) => new double4(v);

        [MethodImpl(Inlining.Always)]
        public static double4 double4(double v) => new double4(v);

        [MethodImpl(Inlining.Always)]
        public static double4 double4(double x, double y, double z, double w) => new double4(x, y, z, w);

        [MethodImpl(Inlining.Always)]
        public static double4 double4(double x, double y, double2 zw) => new double4(x, y, zw);

        [MethodImpl(Inlining.Always)]
        public static double4 double4(double x, double2 yz, double w) => new double4(x, yz, w);

        [MethodImpl(Inlining.Always)]
        public static double4 double4(double x, double3 yzw) => new double4(x, yzw);

        [MethodImpl(Inlining.Always)]
        public static double4 double4(int v) => new double4(v);

        [MethodImpl(Inlining.Always)]
        public static double4 double4(float v) => new double4(v);

        [MethodImpl(Inlining.Always)]
        public static double4 double4(uint v) => new double4(v);

        [MethodImpl(Inlining.Always)]
        public static double4 double4(bool4 v) => new double4(v);

        [MethodImpl(Inlining.Always)]
        public static double4 double4(double2 xy, double z, double w) => new double4(xy, z, w);

        [MethodImpl(Inlining.Always)]
        public static double4 double4(double2 xy, double2 zw) => new double4(xy, zw);

        [MethodImpl(Inlining.Always)]
        public static double4 double4(double3 xyz, double w) => new double4(xyz, w);

        [MethodImpl(Inlining.Always)]
        public static double4 double4(double4 xyzw) => new double4(xyzw);

        [MethodImpl(Inlining.Always)]
        public static double4 double4(float4 v) => new double4(v);

        [MethodImpl(Inlining.Always)]
        public static double4 double4(int4 v) => new double4(v);

        [MethodImpl(Inlining.Always)]
        public static double4 double4(uint4 v) => new double4(v);
    }
}
