namespace FastPoints.HostTests.Repository;

[AttributeUsage(AttributeTargets.Struct)]
internal sealed class GenerateHlslAttribute : Attribute { }

[AttributeUsage(AttributeTargets.Struct)]
internal sealed class DiskFormatAttribute : Attribute { }

internal enum PlantedShape : uint { Square, Disc }

[GenerateHlsl]
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct PlantedRecord
{
    public float3 Corner;
    public uint FirstPoint;
    public int2 Size;
    public PlantedShape Shape;
    public fixed uint Widths[3];
}

[StructLayout(LayoutKind.Sequential)]
internal struct PlantedWithByte
{
    public uint Count;
    public byte Width;
}

[StructLayout(LayoutKind.Explicit)]
internal struct PlantedWithGap
{
    [FieldOffset(0)] public uint Count;
    [FieldOffset(8)] public uint Width;
}

[DiskFormat]
[StructLayout(LayoutKind.Sequential, Pack = 1)]
internal struct PlantedHeader
{
    public uint Magic;
    public ushort Version;
    public long Points;
}
