using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace FastPoints.Laz
{
    /// <summary>One layer within a <see cref="LayeredChunk"/>'s state: its stream, and its contexts, one a scanner channel, each
    /// started when its channel first comes, with what the last point had. HPC#.</summary>
    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct LayerState
    {
        public RangeStream Stream;
        public long EndOffset;
        public LazLayerKind Kind;
        public int RecordOffset;
        public int RecordBytes;
        public int MaxInputBytesPerPoint;
        public int FollowsChannel;
        public int IsWanted;
        public int HasBytes; // 0: all points equal the first.

        public long ContextsOffset;
        public int UsedContexts; // Bit c is set if context c is in use.

        public int Current;

        // Whether the context is new: the caller then starts it with what the last point had.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public bool TryAddContext(int context)
        {
            bool isNew = (UsedContexts >> context & 1) == 0;
            UsedContexts |= 1 << context;
            return isNew;
        }

        public void SaveState(int context, uint value, uint length, byte* next)
        {
            Current = context;
            Stream.Save(value, length, next);
        }
    }

    /// <summary>
    /// What the first layer says of a point that other layers need, packed into 32 bits:
    /// <code>
    /// bits 0-1 scanner channel   2 channel differs from the last point's   3 GPS time changed   4 scan angle changed
    ///      5 point source changed   6-7 kind of return   8-10 level   11-15 context of Z
    /// </code>
    /// </summary>
    static class PointContext
    {
        public const uint ChannelMask = 3;
        public const uint ChannelChangedBit = 4;
        public const int TimeShift = 3;
        public const uint TimeChangedBit = 8;
        public const uint AngleChangedBit = 16;
        public const uint SourceChangedBit = 32;
        public const int ReturnKindShift = 6;
        public const int LevelShift = 8;
        public const int ZShift = 11;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static int ContextIndexOf(uint point, int followsChannel) =>
            followsChannel != 0 || (point & ChannelChangedBit) != 0 ? (int)(point & ChannelMask) : 0;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static int ReturnKind(uint point) => (int)(point >> ReturnKindShift & 3);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static int Level(uint point) => (int)(point >> LevelShift & 7);
    }
}
