using System.Runtime.CompilerServices;
using FastPoints.Streaming;
using Unity.Mathematics;

namespace FastPoints.Drawing
{
    // Which points of a node are drawn while it appears or leaves: those whose hash is below a threshold. A point that is drawn
    // stays until the threshold falls below it again. The twin of PointFilters.hlsl.
    internal static class PointFade
    {
        const int ThresholdBits = 12, SeedBit = 14;

        // Bits 1-13: the threshold, 4096 for all points; bits 14-31: what makes the hashes of nodes differ.
        public static uint BitsOf(in DrawnNode node)
        {
            uint threshold = (uint)math.round(math.saturate(node.DrawnFraction) * (1 << ThresholdBits));
            uint seed = (uint)node.Node * 0x9E3779B9u ^ (uint)node.Page * 0x85EBCA6Bu ^ (uint)node.Cloud * 0xC2B2AE35u;
            return threshold << 1 | seed >> SeedBit << SeedBit;
        }

        public static bool HasAll(uint bits) => ThresholdOf(bits) == 1 << ThresholdBits;

        // index: of the point in its node.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static bool IsDrawn(uint bits, uint index)
        {
            // After the finalizer of MurmurHash3 (Appleby, 2008): neighbours in the node are unrelated.
            uint hash = (index + (bits >> SeedBit) * 0x9E3779B9u) * 0x85EBCA6Bu;
            hash = (hash ^ hash >> 13) * 0xC2B2AE35u;
            return (hash ^ hash >> 16) >> 32 - ThresholdBits < ThresholdOf(bits);
        }

        static uint ThresholdOf(uint bits) => bits >> 1 & 0x1FFFu;
    }
}
