using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Store
{
    // One operation, as jobs read it: ranges of lists that all share.
    internal unsafe struct EditStep
    {
        public EditAction Action;
        public int FirstBox;
        public int BoxCount;
        public int FirstBall;
        public int BallCount;
        public int FirstEdge;
        public int EdgeCount;
        public EditPrism Prism;
        public int FirstCondition;
        public int ConditionCount;

        // What it makes of some columns.
        public int ChangeCount;
        public fixed int Columns[3];
        public fixed int Values[3];

        public void Add(int column, int value)
        {
            Columns[ChangeCount] = column;
            Values[ChangeCount++] = value;
        }
    }

    // An attribute that operations read or change.
    internal struct EditColumn
    {
        // Among the planes that are there.
        public int Plane;
        public int Column;
        public StoredColumn Stored;

        // Of the values of one block, and of those of all blocks if it is changed.
        public PointColumn Block;
        public PointColumn Values;
        public bool IsChanged;
    }

    // The points of a block, a bit each.
    internal struct PointMask
    {
        public ulong Low;
        public ulong High;

        public static PointMask Of(int points) => new PointMask
        {
            Low = points >= 64 ? ulong.MaxValue : (1ul << points) - 1,
            High = points >= 128 ? ulong.MaxValue : points <= 64 ? 0 : (1ul << points - 64) - 1,
        };

        public readonly bool IsEmpty => (Low | High) == 0;

        public readonly int Count => math.countbits(Low) + math.countbits(High);

        public readonly bool Has(int point) => ((point < 64 ? Low >> point : High >> point - 64) & 1) != 0;

        public void Remove(int point)
        {
            if (point < 64)
                Low &= ~(1ul << point);
            else
                High &= ~(1ul << point - 64);
        }

        public readonly PointMask Without(PointMask other) => new PointMask { Low = Low & ~other.Low, High = High & ~other.High };

        public readonly PointMask With(PointMask other) => new PointMask { Low = Low | other.Low, High = High | other.High };
    }

    // What operations made of a block's points.
    internal struct EditedBlock
    {
        public PointMask Deleted;
        public PointMask Hidden;
        public bool HasValues;
    }

    // Applies operations in their order to some blocks of a node. What a block's bounds decide needs no look at its points; of
    // the others only those are unpacked that an operation wants. A node that is damaged stays as it is.
    [BurstCompile]
    internal unsafe struct EditNodeJob : IJob
    {
        [ReadOnly] public NativeArray<EditStep> Steps;
        [ReadOnly] public NativeArray<EditBox> Boxes;
        [ReadOnly] public NativeArray<EditBall> Balls;
        [ReadOnly] public NativeArray<EditEdge> Edges;
        [ReadOnly] public NativeArray<FilterStep> Conditions;
        [ReadOnly] public NativeArray<EditColumn> Columns;
        [ReadOnly] public NativeArray<byte> File;
        [ReadOnly] public NativeArray<PlaneRange> Ranges;
        [ReadOnly] public NativeArray<long> Places;
        [ReadOnly] public NativeArray<PlaneShape> Shapes;
        public Grid3 Corner;
        public int BlockCount;
        public int First;
        public int End;

        // Of one block: positions in whole steps, and the values of Columns.
        public NativeArray<byte> Block;
        public PointColumn X;
        public PointColumn Y;
        public PointColumn Z;
        public NativeArray<int> Near;

        public NativeArray<EditedBlock> Points;
        public NativeArray<byte> Values;
        public NativeArray<long> Changed; // By operation.

        // A block while operations are applied to it.
        struct State
        {
            public int Block;
            public int Points;
            public EditBox Box;
            public bool HasPositions;
            public bool HasValues;
            public EditedBlock Edited;
            public FilterMemory Memory;
        }

        public void Execute()
        {
            byte* results = stackalloc byte[FilterSteps.ResultsBytes];
            double* left = stackalloc double[ColumnValues.BatchLength], right = stackalloc double[ColumnValues.BatchLength];
            bool isValid = AreValid();
            for (int b = First; b < End; b++)
            {
                var state = new State { Block = b, Memory = new FilterMemory { Results = results, Left = left, Right = right } };
                if (isValid)
                    Run(ref state);
                Points[b] = state.Edited;
            }
        }

        bool AreValid()
        {
            var file = (byte*)File.GetUnsafeReadOnlyPtr();
            for (int p = 0; p < Places.Length; p++)
                if (!PlaneView.IsValid(file + Places[p], Ranges[p].LengthBytes, Shapes[p], BlockCount))
                    return false;
            return true;
        }

        PlaneView ViewOf(int plane) =>
            new PlaneView((byte*)File.GetUnsafeReadOnlyPtr() + Places[plane], Shapes[plane], BlockCount);

        void Run(ref State state)
        {
            var positions = ViewOf(StoreLayout.PositionPlane);
            state.Points = positions.PointsOf(state.Block);
            state.Box.Min = Corner + new Grid3((long)positions.MinimumOf(state.Block, 0),
                (long)positions.MinimumOf(state.Block, 1), (long)positions.MinimumOf(state.Block, 2));
            state.Box.Max = state.Box.Min + new Grid3(ExtentOf(positions.WidthOf(state.Block, 0)),
                ExtentOf(positions.WidthOf(state.Block, 1)), ExtentOf(positions.WidthOf(state.Block, 2)));
            for (int s = 0; s < Steps.Length; s++)
            {
                var step = Steps[s];
                var chosen = PointMask.Of(state.Points).Without(state.Edited.Deleted);
                if (!chosen.IsEmpty && MayReach(step, state.Box))
                    Choose(step, ref chosen, ref state);
                else
                    continue;
                if (!chosen.IsEmpty)
                    Changed[s] += Apply(step, chosen, ref state).Count;
            }
            if (state.Edited.HasValues)
                KeepValues(state);
        }

        static long ExtentOf(int width) => (1L << math.min(width, GridCube.MaxSideLog2)) - 1;

        // Before a point is looked at.
        bool MayReach(in EditStep step, in EditBox box)
        {
            bool isReached = step.BoxCount == 0;
            for (int b = 0; b < step.BoxCount && !isReached; b++)
                isReached = Boxes[step.FirstBox + b].ReachOf(box) != EditReach.None;
            if (!isReached || step.Prism.IsUsed && !step.Prism.TryProject(box, out _))
                return false;
            isReached = step.BallCount == 0;
            for (int b = 0; b < step.BallCount && !isReached; b++)
                isReached = Balls[step.FirstBall + b].ReachOf(box) != EditReach.None;
            return isReached;
        }

        // Removes points that the operation does not mean.
        void Choose(in EditStep step, ref PointMask chosen, ref State state)
        {
            if (step.BoxCount > 0)
                ChooseInBoxes(step, ref chosen, ref state);
            if (step.BallCount > 0 && !chosen.IsEmpty)
                ChooseInBalls(step, ref chosen, ref state);
            if (step.Prism.IsUsed && !chosen.IsEmpty)
                ChooseInPrism(step, ref chosen, ref state);
            if (step.ConditionCount > 0 && !chosen.IsEmpty)
                ChooseByConditions(step, ref chosen, ref state);
        }

        void ChooseInBoxes(in EditStep step, ref PointMask chosen, ref State state)
        {
            int near = 0;
            for (int b = step.FirstBox; b < step.FirstBox + step.BoxCount; b++)
            {
                var reach = Boxes[b].ReachOf(state.Box);
                if (reach == EditReach.All)
                    return;
                if (reach == EditReach.Some)
                    Near[near++] = b;
            }
            LoadPositions(ref state);
            for (int i = 0; i < state.Points; i++)
            {
                bool isInside = false;
                for (int n = 0; n < near && !isInside; n++)
                    isInside = Boxes[Near[n]].Holds(PositionOf(i));
                if (!isInside)
                    chosen.Remove(i);
            }
        }

        void ChooseInBalls(in EditStep step, ref PointMask chosen, ref State state)
        {
            int near = 0;
            for (int b = step.FirstBall; b < step.FirstBall + step.BallCount; b++)
            {
                var reach = Balls[b].ReachOf(state.Box);
                if (reach == EditReach.All)
                    return;
                if (reach == EditReach.Some)
                    Near[near++] = b;
            }
            LoadPositions(ref state);
            for (int i = 0; i < state.Points; i++)
            {
                bool isInside = false;
                for (int n = 0; n < near && !isInside && chosen.Has(i); n++)
                    isInside = Balls[Near[n]].Holds(PositionOf(i));
                if (!isInside)
                    chosen.Remove(i);
            }
        }

        void ChooseInPrism(in EditStep step, ref PointMask chosen, ref State state)
        {
            if (!step.Prism.TryProject(state.Box, out var seen))
            {
                chosen = default;
                return;
            }
            var edges = (EditEdge*)Edges.GetUnsafeReadOnlyPtr();
            int near = 0;
            bool isCrossed = false;
            for (int e = step.FirstEdge; e < step.FirstEdge + step.EdgeCount; e++)
            {
                if (!edges[e].MayMatterTo(seen, true))
                    continue;
                Near[near++] = e;
                isCrossed |= edges[e].MayMatterTo(seen, false);
            }
            var nearest = (int*)Near.GetUnsafeReadOnlyPtr();
            if (!isCrossed)
            {
                if (!EditEdge.Hold(edges, nearest, near, seen.FromU, seen.FromV))
                    chosen = default;
                return;
            }
            LoadPositions(ref state);
            for (int i = 0; i < state.Points; i++)
                if (chosen.Has(i) && !(step.Prism.TryProject(PositionOf(i), out long u, out long v) &&
                    EditEdge.Hold(edges, nearest, near, u, v)))
                    chosen.Remove(i);
        }

        void ChooseByConditions(in EditStep step, ref PointMask chosen, ref State state)
        {
            LoadPositions(ref state);
            LoadValues(ref state);
            FilterSteps.Evaluate((FilterStep*)Conditions.GetUnsafeReadOnlyPtr() + step.FirstCondition, step.ConditionCount,
                (byte*)Block.GetUnsafeReadOnlyPtr(), 0, state.Points, state.Memory);
            for (int i = 0; i < state.Points; i++)
                if (state.Memory.Results[i] == 0)
                    chosen.Remove(i);
        }

        // Returns the points that it changed.
        PointMask Apply(in EditStep step, PointMask chosen, ref State state)
        {
            if (step.Action == EditAction.Delete)
            {
                state.Edited.Deleted = state.Edited.Deleted.With(chosen);
                return chosen;
            }
            if (step.Action == EditAction.Hide)
            {
                var shown = chosen.Without(state.Edited.Hidden);
                state.Edited.Hidden = state.Edited.Hidden.With(chosen);
                return shown;
            }
            LoadValues(ref state);
            var block = (byte*)Block.GetUnsafePtr();
            for (int i = 0; i < state.Points; i++)
            {
                bool isChanged = false;
                for (int c = 0; c < step.ChangeCount && chosen.Has(i); c++)
                {
                    var column = Columns[step.Columns[c]].Block;
                    byte* values = block + column.OffsetBytes;
                    isChanged |= ColumnValues.ToDouble(values, column.Type, i) != step.Values[c];
                    ColumnValues.Put(values, column.Type, i, step.Values[c]);
                }
                if (!isChanged)
                    chosen.Remove(i);
            }
            state.Edited.HasValues |= !chosen.IsEmpty;
            return chosen;
        }

        void LoadPositions(ref State state)
        {
            if (state.HasPositions)
                return;
            state.HasPositions = true;
            var view = ViewOf(StoreLayout.PositionPlane);
            var block = (byte*)Block.GetUnsafePtr();
            view.UnpackPositions(state.Block, 0, Corner.X, 0, state.Points, (long*)(block + X.OffsetBytes));
            view.UnpackPositions(state.Block, 1, Corner.Y, 0, state.Points, (long*)(block + Y.OffsetBytes));
            view.UnpackPositions(state.Block, 2, Corner.Z, 0, state.Points, (long*)(block + Z.OffsetBytes));
        }

        Grid3 PositionOf(int point)
        {
            var block = (byte*)Block.GetUnsafeReadOnlyPtr();
            return new Grid3(((long*)(block + X.OffsetBytes))[point], ((long*)(block + Y.OffsetBytes))[point],
                ((long*)(block + Z.OffsetBytes))[point]);
        }

        void LoadValues(ref State state)
        {
            if (state.HasValues)
                return;
            state.HasValues = true;
            for (int c = 0; c < Columns.Length; c++)
            {
                var column = Columns[c];
                ViewOf(column.Plane).UnpackValues(state.Block, column.Column, column.Stored, 0, state.Points,
                    (byte*)Block.GetUnsafePtr() + column.Block.OffsetBytes);
            }
        }

        void KeepValues(in State state)
        {
            for (int c = 0; c < Columns.Length; c++)
            {
                var column = Columns[c];
                int size = column.Block.Type.SizeOf();
                if (column.IsChanged)
                    UnsafeUtility.MemCpy((byte*)Values.GetUnsafePtr() + column.Values.OffsetBytes +
                        (long)state.Block * PlaneShape.MaxPointsPerBlock * size,
                        (byte*)Block.GetUnsafeReadOnlyPtr() + column.Block.OffsetBytes, (long)state.Points * size);
            }
        }
    }
}
