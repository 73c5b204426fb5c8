using System;
using Unity.Mathematics;

namespace FastPoints.Surface
{
    /// <summary>Cubes of voxels that surfaces are made in. Places are metres from the corner of a cloud's root, along the
    /// source's axes.</summary>
    internal readonly struct SurfaceGrid : IEquatable<SurfaceGrid>
    {
        /// <summary>Vertices are at whole steps: neighbours have the same ones on their common faces.</summary>
        public const int StepsPerVoxel = 4096;
        public const int FitReach = 2; // Neighbours so many voxels away make a voxel's normal.
        public const int VertexReach = 2; // A vertex is moved by surfels in voxels so far from its own.

        public const float MaxHoleVoxels = 8;

        public readonly double VoxelMetres;
        public readonly int CellEdgeVoxels;
        public readonly float HoleVoxels; // The widest holes that are closed; 0 for none.

        public SurfaceGrid(double voxelMetres, int cellEdgeVoxels, float holeVoxels)
        {
            if (!(voxelMetres > 0) || double.IsInfinity(voxelMetres))
                throw new ArgumentOutOfRangeException(nameof(voxelMetres), voxelMetres, "wanted a length above 0");
            if (cellEdgeVoxels < 1 || cellEdgeVoxels > 256)
                throw new ArgumentOutOfRangeException(nameof(cellEdgeVoxels), cellEdgeVoxels, "wanted 1 to 256 voxels");
            if (!(holeVoxels >= 0 && holeVoxels <= MaxHoleVoxels))
                throw new ArgumentOutOfRangeException(nameof(holeVoxels), holeVoxels,
                    "wanted 0 to " + NumberText.Of(MaxHoleVoxels) + " voxels");
            VoxelMetres = voxelMetres;
            CellEdgeVoxels = cellEdgeVoxels;
            HoleVoxels = holeVoxels;
        }

        public double CellMetres => VoxelMetres * CellEdgeVoxels;

        public int HoleReach => (int)math.ceil(HoleVoxels);
        public int HoleRings => (int)math.ceil(HoleVoxels / 2); // How many voxels a hole is closed inwards from its rim.

        /// <summary>Voxels around a cell that its surface depends on: a vertex of the cube before the first one, its surfels,
        /// which may close a hole, whose rim has normals.</summary>
        public int Margin => 1 + VertexReach + HoleRings + HoleReach + FitReach;

        public int SideWithMargins => CellEdgeVoxels + 2 * Margin;

        /// <summary>Points so far outside of a cell may make a part of its surface, in metres.</summary>
        public double ReachMetres => (2 + HoleRings) * VoxelMetres;

        public int3 CellOf(double3 metres)
        {
            var cell = math.floor(metres / CellMetres);
            return new int3((int)cell.x, (int)cell.y, (int)cell.z);
        }

        public bool Equals(SurfaceGrid other) => VoxelMetres == other.VoxelMetres && CellEdgeVoxels == other.CellEdgeVoxels &&
            HoleVoxels == other.HoleVoxels;
    }
}
