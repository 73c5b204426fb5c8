using System;
using System.Collections.Generic;
using FastPoints.Nodes;
using FastPoints.Store;

namespace FastPoints.Build
{
    /// <summary>What headers and a sample decide of a cloud, before a point is built.</summary>
    internal sealed class CloudPlan
    {
        /// <summary>Of the whole cloud, as if it were one part.</summary>
        public BuildPart Whole { get; private set; }

        /// <summary>Of the cloud, without what only its points tell.</summary>
        public CloudManifest Manifest { get; private set; }

        /// <summary>Estimates, by base cell.</summary>
        public double[] PointsOfCell { get; private set; }

        /// <summary>See <see cref="Las.LasRecords"/>; null if the sources are not LAS files.</summary>
        public byte[] LasRecords { get; private set; }

        /// <summary>Cubes of parts, which fill that of the cloud, in Morton order: the largest ones with so many points at most by
        /// the estimate, and no smaller than base cells.</summary>
        public GridCube[] CubesOf(double pointsPerPart)
        {
            // A part that has all points of the cloud must know it: what is stored begins at their smallest cube.
            int found = Array.FindAll(PointsOfCell, points => points > 0).Length, next = 0;
            return found < 2 ? new[] { Whole.Cube } : CubeGroups.Of(Whole.Cube, Whole.BaseCells, cell => cell,
                _ => (long)Math.Ceiling(PointsOfCell[next++]), (long)pointsPerPart)
                .ConvertAll(g => g.Count == 1 ? Whole.BaseCells[g.First] : g.Cube).ToArray();
        }

        /// <param name="values">Of the sample, by attribute.</param>
        public static CloudPlan Of(BuildContext build, AttributeStatistics[] values, byte[] lasRecords)
        {
            var divisors = new int[values.Length];
            for (int a = 0; a < divisors.Length; a++)
                divisors[a] = AttributeSummary.DivisorOf(values[a], build.Attributes[a]);
            var whole = new BuildPart
            {
                CloudId = build.CloudId,
                Points = build.Points,
                PointsPerChunk = build.Plan.PointsPerChunk,
                Grid = build.Grid.Grid,
                Records = build.Records,
                Attributes = build.Attributes,
                Divisors = divisors,
                Whole = build.Map.Cube,
                Cube = build.Map.Cube,
                BaseCells = build.Map.BaseCells,
            };
            var manifest = whole.ToManifest(build.Settings.Sampler);
            CloudDescription.DescribeMeaning(build.Readers, manifest);
            return new CloudPlan
            {
                Whole = whole,
                Manifest = manifest,
                PointsOfCell = build.Map.PointsOfBaseCell,
                LasRecords = lasRecords,
            };
        }
    }
}
