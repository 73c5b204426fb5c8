using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Store
{
    // Checks everything of a chunk's table before it builds a page.
    [BurstCompile]
    internal unsafe struct BuildHierarchyPageJob : IJob
    {
        // Node records, then each node's plane ranges.
        [ReadOnly] public NativeArray<byte> Table;
        public ChunkRecord Chunk;
        public HierarchyGrid Grid;
        [ReadOnly] public NativeArray<PlaneShape> Shapes;
        [ReadOnly] public NativeArray<int> Wanted;

        // The page, if Problem is none; the code that takes it owns its memory.
        public NativeReference<HierarchyPage> Built;
        public NativeReference<TableProblem> Problem;

        public TableCheck Check => new TableCheck
        {
            Nodes = (NodeRecord*)Table.GetUnsafeReadOnlyPtr(),
            Planes = (PlaneRange*)((byte*)Table.GetUnsafeReadOnlyPtr() + (long)Chunk.NodeCount * NodeRecord.SizeBytes),
            NodeCount = Chunk.NodeCount,
            PlaneCount = Shapes.Length,
            Shapes = (PlaneShape*)Shapes.GetUnsafeReadOnlyPtr(),
            Region = Chunk.Cube,
            DataBytes = Chunk.TableOffset,
            IsChunk = true,
        };

        public void Execute()
        {
            var check = Check;
            Problem.Value = Find(check);
            if (!Problem.Value.IsNone)
                return;
            var page = new HierarchyPage();
            HierarchyPageBuilding.Build(check.Nodes, check.Planes, check.NodeCount, check.PlaneCount,
                (int*)Wanted.GetUnsafeReadOnlyPtr(), Wanted.Length, Grid, null, ref page);
            Built.Value = page;
        }

        TableProblem Find(in TableCheck check)
        {
            if (ContentHash.Of(Table.GetUnsafeReadOnlyPtr(), Table.Length) != Chunk.TableHash)
                return new TableProblem(TableFault.Hash);
            var problem = check.Find();
            long points = 0;
            for (int n = 0; problem.IsNone && n < check.NodeCount; n++)
                points += check.Nodes[n].PointCount;
            if (problem.IsNone && points != Chunk.PointCount)
                problem = new TableProblem(TableFault.PointSum, 0, Chunk.PointCount, points);
            return problem;
        }
    }
}
