using FastPoints.Streaming;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Drawing
{
    // Lists the nodes that one camera sees, and each block's node, bank by bank.
    [BurstCompile]
    internal unsafe struct ListBlocksJob : IJob
    {
        [ReadOnly] public NativeArray<DrawnNode> Drawn;

        // By cloud number; clouds without pages are not drawn.
        [ReadOnly] public NativeArray<DrawListCloud> Clouds;

        // Empty if no size is adaptive.
        [ReadOnly] public NativeArray<int> SizeNodeOfDrawn;

        public NativeList<GpuNode> Nodes;
        public NativeList<uint> NodeOfInstance;
        public NativeList<BankDraw> Draws;
        public NativeList<int> InstanceOfBank; // Scratch: by bank, then by visible node.
        public NativeList<int> Seen;
        public NativeReference<long> Points;

        public void Execute()
        {
            Nodes.Clear();
            Draws.Clear();
            Seen.Clear();
            InstanceOfBank.Clear();
            Points.Value = 0;
            int instances = CountBlocks();
            NodeOfInstance.ResizeUninitialized(instances);
            int first = 0;
            for (int bank = 0; bank < InstanceOfBank.Length; bank++)
            {
                int count = InstanceOfBank[bank];
                if (count > 0)
                    Draws.Add(new BankDraw { Bank = bank, FirstInstance = first, InstanceCount = count });
                InstanceOfBank[bank] = first;
                first += count;
            }
            Write();
        }

        int CountBlocks()
        {
            var clouds = (DrawListCloud*)Clouds.GetUnsafeReadOnlyPtr();
            int instances = 0;
            for (int i = 0; i < Drawn.Length; i++)
            {
                var drawn = Drawn[i];
                var cloud = clouds + drawn.Cloud;
                if (cloud->Pages == null)
                    continue;
                var node = cloud->Pages[drawn.Page].Nodes + drawn.Node;
                if (!cloud->IntersectsFrustum(node->Center, node->Half))
                    continue;
                while (InstanceOfBank.Length <= drawn.Range.Bank)
                    InstanceOfBank.Add(0);
                InstanceOfBank[drawn.Range.Bank] += node->BlockCount;
                instances += node->BlockCount;
                Points.Value += node->PointCount;
                Seen.Add(i);
            }
            return instances;
        }

        void Write()
        {
            var clouds = (DrawListCloud*)Clouds.GetUnsafeReadOnlyPtr();
            for (int i = 0; i < Seen.Length; i++)
            {
                var drawn = Drawn[Seen[i]];
                var cloud = clouds + drawn.Cloud;
                int blocks = cloud->Pages[drawn.Page].Nodes[drawn.Node].BlockCount;
                var node = cloud->ToGpu(drawn);
                int instance = InstanceOfBank[drawn.Range.Bank];
                InstanceOfBank[drawn.Range.Bank] = instance + blocks;
                node.FirstInstance = (uint)instance;
                node.SizeNode = SizeNodeOfDrawn.Length > 0 ? (uint)SizeNodeOfDrawn[Seen[i]] : 0;
                var nodeOfInstance = NodeOfInstance.GetUnsafePtr();
                for (int block = 0; block < blocks; block++)
                    nodeOfInstance[instance + block] = (uint)Nodes.Length;
                Nodes.Add(node);
            }
        }
    }

    internal struct BankDraw
    {
        public int Bank;
        public int FirstInstance;
        public int InstanceCount; // Blocks of up to 128 points.
    }
}
