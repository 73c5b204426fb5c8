using System;
using System.Collections.Generic;
using FastPoints.Points;
using FastPoints.Store;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Verify
{
    /// <summary>Checks the distances of one file's sampled points, level by level.</summary>
    sealed class SpacingCheck : IDisposable
    {
        readonly CloudManifest m_manifest;
        readonly GridCube m_cube;
        readonly bool m_isUpper;
        NativeArray<SampledGroup> m_runs;
        NativeArray<double3> m_atSides;
        NativeArray<int> m_atSidesOfRun;

        /// <param name="cube">A cube that contains all of the file's points.</param>
        /// <param name="isUpper">Whether it is the file of the upper levels, which are not sampled in one go.</param>
        public SpacingCheck(CloudManifest manifest, NodeTable table, GridCube cube, bool isUpper)
        {
            m_manifest = manifest;
            m_cube = cube;
            m_isUpper = isUpper;
            var runs = new SortedDictionary<(int Level, bool IsTop, int SampledWith), SampledGroup>();
            for (int n = 0; n < table.Nodes.Length; n++)
            {
                var node = table.Nodes[n];
                if (!node.HasSpacing)
                    continue;
                runs.TryGetValue(KeyOf(node), out var run);
                double spacing = math.cmin(manifest.Grid.Step) * math.pow(2.0, node.CellLog2);
                run.Level = KeyOf(node).Level;
                run.Spacing = run.Count == 0 ? spacing : Math.Min(run.Spacing, spacing);
                run.Count += node.PointCount;
                run.IsTop = KeyOf(node).IsTop;
                runs[KeyOf(node)] = run;
            }
            int points = 0, count = 0;
            var next = new Dictionary<(int Level, bool IsTop, int SampledWith), int>();
            m_runs = new NativeArray<SampledGroup>(runs.Count, Allocator.Persistent);
            foreach (var entry in runs)
            {
                var run = entry.Value;
                run.First = points;
                next[entry.Key] = points;
                points = checked(points + run.Count);
                m_runs[count++] = run;
            }
            FirstSampled = new NativeArray<int>(table.Nodes.Length, Allocator.Persistent);
            var first = FirstSampled;
            for (int n = 0; n < table.Nodes.Length; n++)
            {
                var node = table.Nodes[n];
                first[n] = node.HasSpacing ? next[KeyOf(node)] : -1;
                if (first[n] >= 0)
                    next[KeyOf(node)] += node.PointCount;
            }
            Sampled = new NativeArray<double3>(points, Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
            m_atSides = new NativeArray<double3>(points, Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
            m_atSidesOfRun = new NativeArray<int>(runs.Count, Allocator.Persistent);
        }

        /// <summary>By node: where its points go, or -1.</summary>
        public NativeArray<int> FirstSampled { get; private set; }

        /// <summary>Positions of the sampled points in CRS units from the root's corner: to be filled first.</summary>
        public NativeArray<double3> Sampled { get; private set; }

        public JobHandle Schedule()
        {
            var corner = m_cube.Corner - m_manifest.Root.Corner;
            var min = new double3(corner.X, corner.Y, corner.Z) * m_manifest.Grid.Step;
            return new MeasureSpacingJob
            {
                Runs = m_runs,
                Points = Sampled,
                CubeMin = min,
                CubeMax = min + m_manifest.Grid.Step * (double)m_cube.Side,
                IsWhole = m_isUpper,
                AtSides = m_atSides,
                AtSidesOfRun = m_atSidesOfRun,
            }.Schedule();
        }

        /// <summary>Takes the results when the job is done.</summary>
        /// <param name="atSides">Receives the points at the cube's sides for each level.</param>
        public void Take(List<VerifyResult.Level> levels, List<NativeList<double3>> atSides)
        {
            int first = 0;
            for (int r = 0; r < m_runs.Length; r++)
            {
                var run = m_runs[r];
                while (atSides.Count <= run.Level)
                    atSides.Add(new NativeList<double3>(16, Allocator.Persistent));
                if (m_atSidesOfRun[r] > 0)
                    atSides[run.Level].AddRange(m_atSides.GetSubArray(first, m_atSidesOfRun[r]));
                first += m_atSidesOfRun[r];
                var level = levels[run.Level];
                if (!run.IsTop)
                    level.MinDistance = Math.Min(level.MinDistance, run.MinDistance);
                levels[run.Level] = level;
            }
        }

        public void Dispose()
        {
            if (!Sampled.IsCreated)
                return;
            FirstSampled.Dispose();
            Sampled.Dispose();
            m_runs.Dispose();
            m_atSides.Dispose();
            m_atSidesOfRun.Dispose();
            Sampled = default;
        }

        (int Level, bool IsTop, int SampledWith) KeyOf(in NodeRecord node) =>
            (m_manifest.Root.SideLog2 - node.SideLog2, (node.Flags & NodeRecord.IsTop) != 0, node.SampledWith);
    }
}
