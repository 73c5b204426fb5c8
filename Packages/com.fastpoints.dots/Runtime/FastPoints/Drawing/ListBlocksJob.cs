using FastPoints.Streaming;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Drawing
{
    [BurstCompile]
    internal unsafe struct ListBlocksJob : IJob
    {
        [ReadOnly] public NativeArray<DrawnNode> Drawn;
        [ReadOnly] public NativeArray<DrawListCloud> Clouds; // By cloud number; clouds without pages are not drawn.
        [ReadOnly] public NativeArray<int> SizeNodeOfDrawn; // Empty if no size is adaptive.

        public NativeList<GpuNode> Nodes;
        public NativeList<uint> NodeOfInstance;
        public NativeList<BankDraw> Draws;
        public NativeList<int> InstanceOfBank; // Scratch: by bank, then by visible node.
        public NativeList<int> Seen;
        public NativeReference<long> Points;

        // From 1; 0 if nobody asks where nodes were in the list before this one.
        public int ListNumber;
        public NativeList<uint> PreviousFirstInstanceOfNode;
        public NativeList<ListedSlot> ListedOfSlot;

        public void Execute()
        {
            Nodes.Clear();
            Draws.Clear();
            Seen.Clear();
            InstanceOfBank.Clear();
            PreviousFirstInstanceOfNode.Clear();
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
            uint point = 0;
            for (int i = 0; i < Seen.Length; i++)
            {
                var drawn = Drawn[Seen[i]];
                var cloud = clouds + drawn.Cloud;
                var from = cloud->Pages[drawn.Page].Nodes + drawn.Node;
                int blocks = from->BlockCount;
                var node = cloud->ToGpuNode(drawn);
                int instance = InstanceOfBank[drawn.Range.Bank];
                InstanceOfBank[drawn.Range.Bank] = instance + blocks;
                node.FirstInstance = (uint)instance;
                node.SizeNode = SizeNodeOfDrawn.Length > 0 ? (uint)SizeNodeOfDrawn[Seen[i]] : point;
                point += (uint)from->PointCount;
                var nodeOfInstance = NodeOfInstance.GetUnsafePtr();
                for (int block = 0; block < blocks; block++)
                    nodeOfInstance[instance + block] = (uint)Nodes.Length;
                Nodes.Add(node);
                if (ListNumber > 0)
                    PreviousFirstInstanceOfNode.Add(ReplaceFirstInstance(drawn, node.FirstInstance));
            }
        }

        // Where the node's blocks began in the last list; from the next one on, where they begin in this one.
        uint ReplaceFirstInstance(in DrawnNode drawn, uint instance)
        {
            if (ListedOfSlot.Length <= drawn.Slot)
                ListedOfSlot.Resize(drawn.Slot + 1, NativeArrayOptions.ClearMemory);
            ref var listed = ref ListedOfSlot.ElementAt(drawn.Slot);
            bool wasListed = listed.Version == drawn.Version && listed.ListNumber == ListNumber - 1 && ListNumber > 1;
            uint last = wasListed ? listed.FirstInstance : ListedSlot.None;
            listed = new ListedSlot { Version = drawn.Version, ListNumber = ListNumber, FirstInstance = instance };
            return last;
        }
    }

    // The node that a slot of the cache had in a list.
    internal struct ListedSlot
    {
        public const uint None = 0xFFFFFFFF;

        public int Version;
        public int ListNumber;
        public uint FirstInstance;
    }

    internal struct BankDraw
    {
        public int Bank;
        public int FirstInstance;
        public int InstanceCount; // Blocks of up to 128 points.
    }
}
