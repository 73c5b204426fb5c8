using System.Runtime.CompilerServices;
using FastPoints.Streaming;
using Unity.Mathematics;

namespace FastPoints.Drawing
{
    // Which points of a node are drawn while it appears or leaves: those whose hash is not above a threshold. A point that is
    // drawn stays until the threshold falls below it again. The twin of PointFilters.hlsl.
    internal static class PointFade
    {
        public const uint AllBits = 0xFFu << 8;

        // Bits 8-15: the threshold, 255 for all points; bits 16-31: what makes the hashes of nodes differ.
        public static uint BitsOf(in DrawnNode node)
        {
            uint threshold = (uint)math.round(math.saturate(node.Fade) * 255);
            uint seed = (uint)node.Node * 0x9E3779B9u ^ (uint)node.Page * 0x85EBCA6Bu ^ (uint)node.Cloud * 0xC2B2AE35u;
            return threshold << 8 | seed & 0xFFFF0000u;
        }

        // index: of the point in its node.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static bool IsDrawn(uint bits, uint index)
        {
            // After the finalizer of MurmurHash3 (Appleby, 2008): neighbours in the node are unrelated.
            uint hash = (index + (bits >> 16) * 0x9E3779B9u) * 0x85EBCA6Bu;
            hash = (hash ^ hash >> 13) * 0xC2B2AE35u;
            return (hash ^ hash >> 16) >> 24 <= (bits >> 8 & 0xFFu);
        }
    }
}
