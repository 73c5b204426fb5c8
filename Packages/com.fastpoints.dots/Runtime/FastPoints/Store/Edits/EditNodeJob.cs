using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Store
{
    internal struct EditStep
    {
        public EditAction Action;
        public int FirstShape; // Boxes, then balls.
        public int BoxCount;
        public int BallCount;
        public int FirstEdge;
        public int EdgeCount;
        public EditPrism Prism;
        public int FirstCondition;
        public int ConditionCount;

        public int ChangeCount;
        public int3 Columns;
        public int3 Values;
    }

    internal struct EditColumn
    {
        public int Plane; // Among those that are there.
        public int Column;
        public StoredColumn Stored;
        public PointColumn Block; // Where one block's values are.
        public PointColumn Values; // Where those of all blocks are, if it is changed.
        public bool IsChanged;
    }

    internal struct PointMask
    {
        public ulong Low;
        public ulong High;

        public static PointMask OfFirstPoints(int points) => new PointMask
        {
            Low = points >= 64 ? ulong.MaxValue : (1ul << points) - 1,
            High = points >= 128 ? ulong.MaxValue : points <= 64 ? 0 : (1ul << points - 64) - 1,
        };

        public readonly bool IsEmpty => (Low | High) == 0;

        public readonly int Count => math.countbits(Low) + math.countbits(High);

        public readonly bool Has(int point) => ((point < 64 ? Low : High) >> (point & 63) & 1) != 0;

        public void Remove(int point)
        {
            ulong others = ~(1ul << (point & 63));
            Low &= point < 64 ? others : ulong.MaxValue;
            High &= point < 64 ? ulong.MaxValue : others;
        }

        public readonly PointMask Without(PointMask other) => new PointMask { Low = Low & ~other.Low, High = High & ~other.High };

        public readonly PointMask With(PointMask other) => new PointMask { Low = Low | other.Low, High = High | other.High };
    }

    internal struct EditedBlock
    {
        public PointMask Deleted;
        public PointMask Hidden;
        public bool HasChangedValues;
    }

    // Applies operations in their order to some blocks of a node. What a block's bounds decide needs no look at its points; of
    // the others only those are unpacked that an operation wants. A node that is damaged stays as it is.
    [BurstCompile]
    internal unsafe struct EditNodeJob : IJob
    {
        [ReadOnly] public NativeArray<EditStep> Steps;
        [ReadOnly] public NativeArray<EditShape> Shapes;
        [ReadOnly] public NativeArray<EditEdge> Edges;
        [ReadOnly] public NativeArray<FilterStep> Conditions;
        [ReadOnly] public NativeArray<EditColumn> Columns;

        // The node's planes, the position's first, and where each lies in the memory.
        [ReadOnly] public NativeArray<byte> File;
        [ReadOnly] public NativeArray<PlaneRange> Planes;
        [ReadOnly] public NativeArray<long> PlaneOffsets;
        [ReadOnly] public NativeArray<PlaneShape> PlaneShapes;
        public Grid3 Corner;
        public int BlockCount;
        public int First;
        public int End;

        // Of one block: x, y and z in whole steps, and the values of Columns.
        public NativeArray<byte> Block;
        [ReadOnly] public NativeArray<PointColumn> Axes;
        public NativeArray<int> Near;

        // By block, by block and point, by operation.
        public NativeArray<EditedBlock> EditedBlocks;
        public NativeArray<byte> Values;
        public NativeArray<long> Changed;

        struct State
        {
            public int Block;
            public int Points;
            public EditShape Box;
            public bool HasPositions;
            public bool HasValues;
            public PointMask Chosen;
            public EditedBlock Edited;
            public FilterMemory Memory;
        }

        byte* BlockBytes => (byte*)Block.GetUnsafePtr();

        public void Execute()
        {
            byte* results = stackalloc byte[FilterSteps.ResultsBytes];
            double* left = stackalloc double[ColumnValues.BatchLength], right = stackalloc double[ColumnValues.BatchLength];
            var file = (byte*)File.GetUnsafeReadOnlyPtr();
            bool isValid = true;
            for (int p = 0; p < PlaneOffsets.Length && isValid; p++)
                isValid = PlaneView.IsValid(file + PlaneOffsets[p], Planes[p].LengthBytes, PlaneShapes[p], BlockCount);
            for (int b = First; b < End; b++)
            {
                var state = new State { Block = b, Memory = new FilterMemory { Results = results, Left = left, Right = right } };
                if (isValid)
                    Run(ref state);
                EditedBlocks[b] = state.Edited;
            }
        }

        PlaneView ViewOf(int plane) =>
            new PlaneView((byte*)File.GetUnsafeReadOnlyPtr() + PlaneOffsets[plane], PlaneShapes[plane], BlockCount);

        void Run(ref State state)
        {
            var view = ViewOf(StoreLayout.PositionPlane);
            int b = state.Block;
            state.Points = view.PointsOf(b);
            state.Box.A = Corner + new Grid3((long)view.MinimumOf(b, 0), (long)view.MinimumOf(b, 1), (long)view.MinimumOf(b, 2));
            state.Box.B = state.Box.A + new Grid3(ExtentOf(view.WidthOf(b, 0)), ExtentOf(view.WidthOf(b, 1)),
                ExtentOf(view.WidthOf(b, 2)));
            for (int s = 0; s < Steps.Length; s++)
            {
                var step = Steps[s];
                state.Chosen = PointMask.OfFirstPoints(state.Points).Without(state.Edited.Deleted);
                if (step.BoxCount > 0)
                    FilterByShapes(step.FirstShape, step.BoxCount, ref state);
                if (step.BallCount > 0)
                    FilterByShapes(step.FirstShape + step.BoxCount, step.BallCount, ref state);
                if (step.Prism.IsUsed)
                    FilterByPrism(step, ref state);
                if (step.ConditionCount > 0)
                    FilterByConditions(step, ref state);
                if (!state.Chosen.IsEmpty)
                    Changed[s] += Apply(step, ref state);
            }
            if (state.Edited.HasChangedValues)
                KeepValues(state);
        }

        static long ExtentOf(int width) => (1L << math.min(width, GridCube.MaxSideLog2)) - 1;

        // Each of the next three removes points from the block's mask: those outside all shapes, outside the prism, or that
        // fail a condition.
        void FilterByShapes(int first, int count, ref State state)
        {
            int near = 0;
            for (int n = first; n < first + count; n++)
            {
                var reach = Shapes[n].ReachOf(state.Box);
                if (reach == EditReach.All)
                    return;
                if (reach == EditReach.Some)
                    Near[near++] = n;
            }
            if (near > 0)
                LoadPositions(ref state);
            for (int i = 0; i < state.Points; i++)
            {
                bool isInside = false;
                for (int n = 0; n < near && !isInside && state.Chosen.Has(i); n++)
                    isInside = Shapes[Near[n]].Holds(PositionOf(i));
                if (!isInside)
                    state.Chosen.Remove(i);
            }
        }

        void FilterByPrism(in EditStep step, ref State state)
        {
            var edges = (EditEdge*)Edges.GetUnsafeReadOnlyPtr();
            var nearest = (int*)Near.GetUnsafeReadOnlyPtr();
            int near = 0;
            bool isCrossed = false, isSeen = step.Prism.TryProject(state.Box, out var seen);
            for (int e = step.FirstEdge; e < step.FirstEdge + step.EdgeCount && isSeen && !state.Chosen.IsEmpty; e++)
            {
                if (edges[e].MayMatterTo(seen, out bool mayCross))
                    Near[near++] = e;
                isCrossed |= mayCross;
            }
            if (!isCrossed)
            {
                if (!EditEdge.Hold(edges, nearest, near, seen.FromU, seen.FromV))
                    state.Chosen = default;
                return;
            }
            LoadPositions(ref state);
            for (int i = 0; i < state.Points; i++)
            {
                var at = PositionOf(i);
                if (state.Chosen.Has(i) && !(step.Prism.TryProject(new EditShape { A = at, B = at }, out var place) &&
                    EditEdge.Hold(edges, nearest, near, place.FromU, place.FromV)))
                    state.Chosen.Remove(i);
            }
        }

        void FilterByConditions(in EditStep step, ref State state)
        {
            if (state.Chosen.IsEmpty)
                return;
            LoadPositions(ref state);
            LoadValues(ref state);
            FilterSteps.Evaluate((FilterStep*)Conditions.GetUnsafeReadOnlyPtr() + step.FirstCondition, step.ConditionCount,
                BlockBytes, 0, state.Points, state.Memory);
            for (int i = 0; i < state.Points; i++)
                if (state.Memory.Results[i] == 0)
                    state.Chosen.Remove(i);
        }

        // Returns how many points it changed.
        int Apply(in EditStep step, ref State state)
        {
            ref var edited = ref state.Edited;
            var before = edited;
            if (step.Action == EditAction.Delete)
                edited.Deleted = edited.Deleted.With(state.Chosen);
            if (step.Action == EditAction.Hide)
                edited.Hidden = edited.Hidden.With(state.Chosen);
            int changed = edited.Deleted.Without(before.Deleted).Count + edited.Hidden.Without(before.Hidden).Count;
            if (step.ChangeCount > 0)
                LoadValues(ref state);
            for (int i = 0; i < state.Points && step.ChangeCount > 0; i++)
            {
                bool isChanged = false;
                for (int c = 0; c < step.ChangeCount && state.Chosen.Has(i); c++)
                {
                    var column = Columns[step.Columns[c]].Block;
                    isChanged |= ColumnValues.ToDouble(BlockBytes + column.OffsetBytes, column.Type, i) != step.Values[c];
                    ColumnValues.Put(BlockBytes + column.OffsetBytes, column.Type, i, step.Values[c]);
                }
                changed += isChanged ? 1 : 0;
                edited.HasChangedValues |= isChanged;
            }
            return changed;
        }

        void LoadPositions(ref State state)
        {
            for (int axis = 0; axis < 3 && !state.HasPositions; axis++)
                ViewOf(StoreLayout.PositionPlane).UnpackPositions(state.Block, axis,
                    axis == 0 ? Corner.X : axis == 1 ? Corner.Y : Corner.Z, 0, state.Points,
                    (long*)(BlockBytes + Axes[axis].OffsetBytes));
            state.HasPositions = true;
        }

        Grid3 PositionOf(int point) => new Grid3(*(long*)Axes[0].At(BlockBytes, point), *(long*)Axes[1].At(BlockBytes, point),
            *(long*)Axes[2].At(BlockBytes, point));

        void LoadValues(ref State state)
        {
            for (int c = 0; c < Columns.Length && !state.HasValues; c++)
            {
                var column = Columns[c];
                new ColumnUnpacker { View = ViewOf(column.Plane), Column = column.Column, Stored = column.Stored }
                    .Unpack(state.Block, 0, state.Points, BlockBytes + column.Block.OffsetBytes);
            }
            state.HasValues = true;
        }

        void KeepValues(in State state)
        {
            for (int c = 0; c < Columns.Length; c++)
                if (Columns[c].IsChanged)
                    UnsafeUtility.MemCpy(Columns[c].Values.At((byte*)Values.GetUnsafePtr(),
                        state.Block * PlaneShape.MaxPointsPerBlock), BlockBytes + Columns[c].Block.OffsetBytes,
                        (long)state.Points * Columns[c].Block.Type.SizeOf());
        }
    }
}
