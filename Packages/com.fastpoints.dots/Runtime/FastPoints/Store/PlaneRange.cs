using System.Runtime.InteropServices;
using FastPoints.Base;

namespace FastPoints.Store
{
    /// <summary>Where one plane of one node lies in its file.</summary>
    [DiskFormat]
    [StructLayout(LayoutKind.Explicit, Size = SizeBytes)]
    public struct PlaneRange
    {
        public const int SizeBytes = 24;

        [FieldOffset(0)] public long OffsetBytes;
        [FieldOffset(8)] public long LengthBytes;
        [FieldOffset(16)] public ulong Hash;
    }
}
