using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Export
{
    /// <summary>Finds the smallest distance between points of a level that were sampled together, across nodes of one file; and
    /// the points at the sides of the file's cube, which other files' points may be close to. Each slice continues where the one
    /// before ended; one that has nothing left to do ends at once.</summary>
    [BurstCompile]
    internal unsafe struct MeasureSpacingJob : IJob
    {
        /// <summary>Points of a slice that are looked up in a grid: about 2 ms.</summary>
        const int UnitsPerSlice = 4096;

        /// <summary>Points that are compared with the cube for each of these, and units that a slice may waste.</summary>
        const int SidesPerUnit = 32, UnitsToSpare = 16;

        /// <summary>The groups of points, one after the other, level by level.</summary>
        public NativeArray<SampledGroup> Groups;

        /// <summary>In CRS units, from the cloud's corner. Here too without the safety system, which would else see these jobs
        /// in those that write to it side by side.</summary>
        [ReadOnly, NativeDisableContainerSafetyRestriction] public NativeArray<double3> Points;

        /// <summary>What the points' planes and parts showed: a damaged file's distances say nothing.</summary>
        [ReadOnly, NativeDisableContainerSafetyRestriction] public NativeArray<NodeCheckResult> PlaneResults;
        [ReadOnly, NativeDisableContainerSafetyRestriction] public NativeArray<NodeCheckResult> Results;

        /// <summary>The file's cube, in the points' space.</summary>
        public double3 CubeMin;
        public double3 CubeMax;

        /// <summary>Whether all points are wanted, not only those at the sides.</summary>
        public bool IsWhole;

        public NativeReference<SpacingState> State;

        /// <summary>Room for the largest group: see <see cref="ClosestPair.ScratchOf"/>.</summary>
        public NativeArray<int> Scratch;

        /// <summary>Out: the points at the sides, level by level.</summary>
        public NativeList<double3> AtSides;

        public static int SlicesOf(NativeArray<SampledGroup> groups)
        {
            long units = 0;
            for (int g = 0; g < groups.Length; g++)
                units += ClosestPair.UnitsOf(groups[g].Count) + groups[g].Count / SidesPerUnit + 1;
            return (int)(units / (UnitsPerSlice - UnitsToSpare)) + 1;
        }

        public void Execute()
        {
            var state = State.Value;
            if (state.Group == Groups.Length || state.Group == 0 && state.Phase == 0 && HasFault())
                return;
            var points = (double3*)Points.GetUnsafeReadOnlyPtr();
            for (long units = UnitsPerSlice; units > 0 && state.Group < Groups.Length;)
            {
                var group = Groups[state.Group];
                if (state.Phase == 0)
                {
                    state.Closest = new ClosestPair(group.Count);
                    state.Phase++;
                }
                if (state.Phase == 1)
                {
                    if (!state.Closest.Step(points + group.First, (int*)Scratch.GetUnsafePtr(), ref units))
                        continue;
                    group.MinDistance = state.Closest.Distance;
                    state.Phase++;
                    state.Side = group.First;
                }
                int groupEnd = group.First + group.Count;
                int end = (int)math.min(groupEnd, state.Side + math.max(0, units) * SidesPerUnit);
                int before = AtSides.Length;
                for (int i = state.Side; i < end; i++)
                    if (IsWhole || math.cmin(math.min(points[i] - CubeMin, CubeMax - points[i])) < group.Spacing)
                        AtSides.Add(points[i]);
                units -= (end - state.Side) / SidesPerUnit + 1;
                group.AtSides += AtSides.Length - before;
                Groups[state.Group] = group;
                state.Side = end;
                if (end == groupEnd)
                {
                    state.Group++;
                    state.Phase = 0;
                }
            }
            State.Value = state;
        }

        bool HasFault()
        {
            bool has = false;
            for (int i = 0; i < PlaneResults.Length; i++)
                has |= PlaneResults[i].What != NodeCheckResult.Fault.None;
            for (int i = 0; i < Results.Length; i++)
                has |= Results[i].What != NodeCheckResult.Fault.None;
            return has;
        }
    }

    /// <summary>How far the slices have come. Blittable.</summary>
    internal struct SpacingState
    {
        public int Group;
        public int Phase;
        public int Side;
        public ClosestPair Closest;
    }

    /// <summary>The range of a file's points of one level that were sampled together, among all its sampled points.
    /// Blittable.</summary>
    internal struct SampledGroup
    {
        public int First;
        public int Count;

        /// <summary>The level, counted from the root.</summary>
        public int Level;

        /// <summary>Points nearer than this to the file's cube's sides may have neighbours beyond them; CRS units.</summary>
        public double Spacing;

        /// <summary>Whether they are what upper levels left of other nodes' tops, which were not sampled together.</summary>
        public bool IsTop;

        /// <summary>Out: the smallest distance between two of the points, in CRS units.</summary>
        public double MinDistance;

        /// <summary>Out: the number of its points at the sides.</summary>
        public int AtSides;
    }
}
