using System;
using FastPoints.Nodes;
using FastPoints.Reading;
using FastPoints.Store;

namespace FastPoints.Build
{
    /// <summary>What a plan fixes for one of the builds that make a cloud together: with it the bytes of a part are those that one
    /// build of everything would write.</summary>
    internal sealed class BuildPart
    {
        public ulong CloudId;

        /// <summary>By the headers, of the whole cloud.</summary>
        public long Points;

        public long PointsPerChunk;

        public CloudGrid Grid;
        public RecordLayout Records;

        /// <summary>Those of the cloud, beside the position, and a divisor for each.</summary>
        public PointSchema Attributes;
        public int[] Divisors;

        /// <summary>The plan's cube of the cloud. Points outside of it are set aside until all parts are built.</summary>
        public GridCube Whole;

        /// <summary>The part's cube, half-open, and the base cells in it, in Morton order.</summary>
        public GridCube Cube;
        public GridCube[] BaseCells;

        /// <summary>Whether there are no other parts.</summary>
        public bool IsWhole => Cube.Corner == Whole.Corner && Cube.SideLog2 == Whole.SideLog2;

        /// <summary>What the nodes of all parts have in common; counts and ranges are not known.</summary>
        public CloudManifest ToManifest(Sampler sampler)
        {
            var manifest = new CloudManifest
            {
                Sampler = sampler.ToString().ToLowerInvariant(),
                Root = Whole,
                CloudId = CloudId,
                Grid = Grid,
                Attributes = Attributes,
                Divisors = Divisors,
                Ranges = new CloudManifest.Range[Attributes.Count],
            };
            Array.Fill(manifest.Ranges, new CloudManifest.Range { Min = double.NaN, Max = double.NaN });
            return manifest;
        }
    }
}
