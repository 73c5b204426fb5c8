using System;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Surface
{
    internal struct SurfaceVoxel
    {
        public int At; // Its index among all voxels of a cell with margins.
        public uint Count;
        public ulong X; // Sums of steps from its corner: of up to 2^32 points, so that no order of theirs matters.
        public ulong Y;
        public ulong Z;
    }

    /// <summary>A piece of surface, in voxels from its own voxel's corner.</summary>
    internal struct Surfel
    {
        public float3 Position;
        public float3 Normal; // Of length 1; its sign has no meaning.
    }

    internal struct SurfaceMemory : IDisposable
    {
        public const int Rejected = -1; // Of a voxel that closes no hole.
        public NativeArray<int> SurfelOf; // By voxel with margins, x first: 1 more than the number of its surfel; 0 for none.
        public NativeList<SurfaceVoxel> Voxels;
        public NativeList<float3> Means; // Of a voxel's points, in voxels from its corner.
        public NativeList<Surfel> Surfels;

        /// <summary>By lattice point, the corner of the voxel of that index: 1 within the shell around the surfels.</summary>
        public NativeArray<byte> IsInside;
        public NativeArray<byte> IsRowInside; // By row of lattice points along x: whether any is.

        /// <summary>By cube of the cell, and those before its first ones; 0 for none, else 1 more than its vertex.</summary>
        public NativeArray<int> VertexNumberOfCube;
        public NativeList<int3> Vertices; // In steps from the cell's corner.

        /// <summary>Three vertices each; counter-clockwise seen from outside, in the source's right-handed axes.</summary>
        public NativeList<int3> Triangles;

        public SurfaceMemory(in SurfaceGrid grid, Allocator allocator)
        {
            int side = grid.SideWithMargins, cubes = grid.CellEdgeVoxels + 1;
            SurfelOf = new NativeArray<int>(side * side * side, allocator);
            IsInside = new NativeArray<byte>(side * side * side, allocator);
            IsRowInside = new NativeArray<byte>(side * side, allocator);
            VertexNumberOfCube = new NativeArray<int>(cubes * cubes * cubes, allocator);
            Voxels = new NativeList<SurfaceVoxel>(allocator);
            Means = new NativeList<float3>(allocator);
            Surfels = new NativeList<Surfel>(allocator);
            Vertices = new NativeList<int3>(allocator);
            Triangles = new NativeList<int3>(allocator);
        }

        public void Dispose()
        {
            if (!SurfelOf.IsCreated)
                return;
            SurfelOf.Dispose();
            IsInside.Dispose();
            IsRowInside.Dispose();
            VertexNumberOfCube.Dispose();
            Voxels.Dispose();
            Means.Dispose();
            Surfels.Dispose();
            Vertices.Dispose();
            Triangles.Dispose();
        }
    }
}
