using System;
using System.Collections.Generic;
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

        /// <summary>The part of a smaller cube, which holds base cells.</summary>
        public BuildPart Of(GridCube cube)
        {
            var part = (BuildPart)MemberwiseClone();
            part.Cube = cube;
            part.BaseCells = Array.FindAll(BaseCells, cell => cube.Contains(cell));
            return part;
        }

        /// <summary>The part of the points outside of the whole cube: the octants around it that hold all points.</summary>
        public BuildPart OfOutside(in PointStatistics found)
        {
            var part = (BuildPart)MemberwiseClone();
            var cells = new BaseCells(Whole, new[] { Whole }, RootCube.Grow(Whole, found.Min, found.Max));
            part.Cube = cells.Root;
            part.BaseCells = cells.All;
            return part;
        }

        /// <summary>A cube that holds all points of the cloud: the smallest one if the part knows all of them.</summary>
        public GridCube RootOf(in PointStatistics found)
        {
            if (!IsWhole)
                return Cube.Contains(Whole) ? Cube : Whole;
            var grown = RootCube.Grow(Whole, found.Min, found.Max);
            return grown.Length > 0 ? grown[grown.Length - 1] : Whole;
        }

        /// <exception cref="PointCloudException">A value is no multiple of what the plan's sample showed.</exception>
        public void RequireDivisors(IReadOnlyList<AttributeStatistics> found, string path)
        {
            for (int a = 0; a < Attributes.Count; a++)
                if (!found[a].IsEmpty && (Divisors[a] == 257 ? found[a].Modulo257Or != 0
                    : (found[a].Or & (ulong)(Divisors[a] - 1)) != 0))
                    throw new PointCloudException(FailureCode.BadInput, path, -1, "values of " + Attributes[a].Name +
                        " are no multiples of " + Divisors[a] + ", as those of the plan's sample are: plan again with --divisors 1");
        }

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
