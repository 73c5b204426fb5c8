using System;
using System.Collections.Generic;
using FastPoints.Store;
using Unity.Mathematics;

namespace FastPoints.Build
{
    internal sealed class NormalSettings
    {
        public int Neighbours = 16;

        /// <summary>Cubes that are worked on at once are cut until they have no more, but for what upper nodes have
        /// there.</summary>
        public long PointsPerCube = 600_000;
        public Func<int> Workers = () => 0; // The most workers to keep busy, 0 for all; may change meanwhile.
    }

    /// <summary>A cloud's nodes by place. All tables of its pages are in memory.</summary>
    internal sealed class NormalCubes : CloudSelection
    {
        const int MaxLevelsBelow = 12; // Finest cells of a region are at least this far below the smallest node in it.

        /// <summary>Neighbours are looked for as far from a cube as twice as many would reach, where the density is that of
        /// most points.</summary>
        const double MarginSpacings = 2;

        readonly double3 m_metres;
        readonly NormalSettings m_settings;

        public NormalCubes(CloudFolder folder, NormalSettings settings) : base(folder)
        {
            var manifest = folder.Manifest;
            m_settings = settings;
            m_metres = manifest.Crs.Units.MetresAt(manifest.BoundsGeo.Center, UpAxis.Z) * manifest.Grid.Step;
        }

        public NodeTable TableAt(int page) => Load(page);

        /// <summary>Chooses all nodes, so many at a time as have the points of a cube.</summary>
        /// <returns>How many are chosen.</returns>
        public IEnumerable<int> ChooseBatches()
        {
            Clear();
            for (int page = 0; page < Folder.PageCount; page++)
            {
                int nodes = Load(page).Nodes.Length;
                for (int n = 0; n < nodes; n++)
                {
                    Add(page, n, TableOf(page).Nodes[n].PointCount);
                    if (Points < m_settings.PointsPerCube && !(page == Folder.PageCount - 1 && n == nodes - 1))
                        continue;
                    yield return NodeCount;
                    Clear();
                }
            }
        }

        public IEnumerable<GridCube> Cubes() => CubesOf(Folder.Manifest.Root);

        IEnumerable<GridCube> CubesOf(GridCube cube)
        {
            long inside = 0;
            int smallest = cube.SideLog2;
            bool isAny = false;
            foreach (var (page, index) in NodesIn(cube.Corner, EndOf(cube)))
            {
                var node = TableOf(page).Nodes[index];
                isAny |= Intersects(node, cube.Corner, EndOf(cube));
                if (!cube.ContainsAligned(node.Cube))
                    continue;
                inside += node.PointCount;
                smallest = Math.Min(smallest, node.SideLog2);
            }
            if (!isAny)
                yield break;
            if (cube.SideLog2 == 0 || inside <= m_settings.PointsPerCube && smallest >= cube.SideLog2 - MaxLevelsBelow)
            {
                yield return cube;
                yield break;
            }
            for (int octant = 0; octant < 8; octant++)
                foreach (var below in CubesOf(cube.Child(octant)))
                    yield return below;
        }

        public NormalRegion Choose(GridCube cube)
        {
            double weight = 0, sum = 0;
            foreach (var (page, index) in NodesIn(cube.Corner, EndOf(cube)))
            {
                var node = TableOf(page).Nodes[index];
                if (!Intersects(node, cube.Corner, EndOf(cube)))
                    continue;
                weight += node.PointCount;
                sum += node.PointCount * SpacingOf(node);
            }
            var corner = cube.Corner - Folder.Manifest.Root.Corner;
            var region = new NormalRegion
            {
                Min = new double3(corner.X, corner.Y, corner.Z),
                Max = new double3(corner.X, corner.Y, corner.Z) + cube.Side,
                StepMetres = m_metres,
                Neighbours = m_settings.Neighbours,
                MarginMetres = MarginSpacings * math.sqrt(m_settings.Neighbours) * sum / math.max(1, weight),
            };
            var around = StepsOf(region.MarginMetres);
            ChooseIn(cube.Corner - around, EndOf(cube) + around);
            return region;
        }

        public override bool IsRefined(int page, int node) => true;

        Grid3 StepsOf(double metres)
        {
            var steps = math.min(metres / m_metres, 1L << 60);
            return new Grid3(1 + (long)steps.x, 1 + (long)steps.y, 1 + (long)steps.z);
        }

        /// <summary>Of points that are spread over the two longer sides of their bounds.</summary>
        double SpacingOf(in NodeRecord node)
        {
            var size = new double3(node.MaxX - node.MinX + 1.0, node.MaxY - node.MinY + 1.0, node.MaxZ - node.MinZ + 1.0) *
                m_metres * (1L << node.BoundsShift);
            return math.sqrt(size.x * size.y * size.z / math.cmin(size) / node.PointCount);
        }
    }
}
