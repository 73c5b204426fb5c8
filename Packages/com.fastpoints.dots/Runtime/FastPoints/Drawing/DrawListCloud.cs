using System.Runtime.CompilerServices;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Mathematics;

namespace FastPoints.Drawing
{
    internal unsafe struct DrawListCloud
    {
        const uint StoredNormalsBit = 1 << 11;

        public HierarchyPage* Pages;
        public CloudView View;
        public CloudView RightView; // A headset's right eye: nodes that it alone sees are drawn, too.
        public bool HasBothEyes;
        public CloudPlacement Placement;
        public NodeCubes Cubes;
        public CloudLook Look;
        public double3 Step;
        public double3 EyeWorld;
        public int PlaneCount;

        public readonly bool IntersectsFrustum(double3 center, double3 half) =>
            View.IntersectsFrustum(center, half) || (HasBothEyes && RightView.IntersectsFrustum(center, half));

        // Without its first instance and place in the size tree. The planes begin at the bank's first word.
        public readonly GpuNode ToGpuNode(in DrawnNode drawn)
        {
            int page = drawn.Page, node = drawn.Node;
            uint firstWord = (uint)drawn.Range.FirstPage * (NodePool.PageBytes / sizeof(uint));
            var from = Pages + page;
            var address = from->Addresses[node];
            var planes = from->Planes + (long)node * PlaneCount;
            var corner = new double3(address.Corner.X, address.Corner.Y, address.Corner.Z);
            var anchor = AnchorOf(from->Nodes[node], corner, address.IsWide);
            var anchorGrid = corner + new double3(anchor.X, anchor.Y, anchor.Z);
            var cubeCorner = Cubes.CornerAt(Cubes.PositionInCube(from, node), address.Level);
            var cubeSize = Cubes.SizeAt(address.Level);
            var fromEye = Placement.OriginWorld - EyeWorld;
            return new GpuNode
            {
                Anchor = new uint3((uint)anchor.X, (uint)anchor.Y, (uint)anchor.Z),
                AnchorHigh = new uint3((uint)(anchor.X >> 32), (uint)(anchor.Y >> 32), (uint)(anchor.Z >> 32)),
                AnchorView = (float3)(math.mul(Placement.Linear, anchorGrid * Step) + fromEye),
                PositionWord = firstWord,
                ColorWord = Look.Source != ColorSource.Position ? WordOf(planes, Look.Plane, firstWord)
                    : math.asuint((float)(math.dot(Look.ValuePerUnit, anchorGrid * Step) + Look.Bias)),
                NormalWord = WordOf(planes, Look.NormalPlane, firstWord),
                ClassWord = WordOf(planes, Look.ClassPlane, firstWord),
                Cloud = (uint)drawn.Cloud,
                Bits = (address.IsWide ? 1u : 0u) | PointFade.BitsOf(drawn),
                Tint = drawn.Tint,
                AnchorInCube = (float3)((anchorGrid * Step - cubeCorner) / cubeSize),
                CubesPerStep = (float3)(Step / cubeSize),
            };
        }

        static uint WordOf(PlaneRange* planes, int plane, uint firstWord)
        {
            for (int p = 0; p < plane; p++)
                firstWord += (uint)(planes[p].LengthBytes / sizeof(uint));
            return firstWord;
        }

        // plane: index in the layout of the plane that colours the points; classPlane: that of the classes, if some are hidden.
        public readonly GpuCloud ToGpuCloud(StoreLayout layout, int plane, int classPlane)
        {
            var linear = Placement.Linear;
            var cloud = new GpuCloud
            {
                StepX = (float3)(linear.c0 * Step.x),
                StepY = (float3)(linear.c1 * Step.y),
                StepZ = (float3)(linear.c2 * Step.z),
                ColorSource = (uint)Look.Source | (uint)PointLighting.LitLevelOf(Look.Light) << 8,
                ColumnTypes = (uint)Look.Palette << 24,
                ValuePerStep = (float3)(Look.ValuePerUnit * Step),
                Bias = (float)Look.Bias,
                HiddenLow = Look.HiddenClasses.Low,
                HiddenHigh = Look.HiddenClasses.High,
            };
            if (Look.NormalPlane > 0)
            {
                cloud.ColorSource |= StoredNormalsBit;
                var normals = NormalsToWorld(linear, Look.Metres);
                cloud.NormalX = (float4)new double4(normals.c0, 0);
                cloud.NormalY = (float4)new double4(normals.c1, 0);
                cloud.NormalZ = (float4)new double4(normals.c2, 0);
            }
            if (!Look.HiddenClasses.IsEmpty)
                cloud.ClassDivisor = (uint)layout.Columns[layout.Planes[classPlane].FirstColumn].Divisor;
            if (Look.Source == ColorSource.Position)
                return cloud;
            var of = layout.Planes[plane];
            cloud.Columns = (uint)(of.ColumnCount | of.Shape.WideColumnMask << 8);
            for (int c = 0; c < of.ColumnCount; c++)
            {
                var column = layout.Columns[of.FirstColumn + c];
                cloud.ColumnTypes |= (uint)column.Type << (8 * c);
                cloud.Scale[c] = (float)(Look.Scale * column.Divisor);
            }
            return cloud;
        }

        // From normals along a cloud's axes, in metres, to vectors of the world of any length but 0. linear: of the cloud's
        // units.
        public static double3x3 NormalsToWorld(in double3x3 linear, double3 metres)
        {
            var to = math.transpose(math.inverse(linear));
            (to.c0, to.c1, to.c2) = (to.c0 * metres.x, to.c1 * metres.y, to.c2 * metres.z);
            double longest = math.sqrt(math.max(math.lengthsq(to.c0), math.max(math.lengthsq(to.c1), math.lengthsq(to.c2))));
            return new double3x3(to.c0 / longest, to.c1 / longest, to.c2 / longest);
        }

        // The position in the node's box that is nearest to the camera, in grid steps from the node's corner.
        readonly Grid3 AnchorOf(in StreamNode node, double3 corner, bool isWide)
        {
            double largest = isWide ? 1L << 60 : uint.MaxValue;
            var low = math.clamp((node.Center - node.Half) / Step - corner, 0, largest);
            var high = math.clamp((node.Center + node.Half) / Step - corner, 0, largest);
            var nearest = math.round(math.clamp(View.Eye / Step - corner, low, high));
            return new Grid3((long)nearest.x, (long)nearest.y, (long)nearest.z);
        }
    }

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
