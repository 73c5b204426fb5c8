using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Drawing;
using FastPoints.Store;
using Unity.Collections;

namespace FastPoints.Build
{
    /// <summary>Measures what a display needs to know of a stored cloud, from the points of its upper levels.</summary>
    static class StoredRanges
    {
        const int PointsToMeasure = 200_000;

        /// <summary>Measures as a coroutine.</summary>
        /// <param name="selection">A selection of the folder, whose choice changes.</param>
        /// <param name="schema">See <see cref="LoadNodes.SchemaFor"/>.</param>
        /// <param name="ranges">The ranges to fill.</param>
        /// <exception cref="PointCloudException">The cloud cannot be read.</exception>
        public static IEnumerator<JobStep> Measure(CloudFolder folder, NodeSelection selection, PointSchema schema,
            UpAxis upAxis, DisplayRanges ranges)
        {
            selection.Choose(null, PointsToMeasure);
            var transform = folder.Manifest.Grid.FromCorner(folder.Manifest.Root.Corner);
            using var batch = new PointBatch(schema, CheckedCount(folder, selection.Points), Allocator.Persistent);
            yield return JobStep.Of(LoadNodes.Run(folder, selection, batch, null));
            yield return JobStep.Of(ranges.Measure(batch, transform, upAxis));
        }

        /// <exception cref="PointCloudException">There are more points than a batch takes.</exception>
        public static int CheckedCount(CloudFolder folder, long points) =>
            points <= int.MaxValue / 64
                ? (int)points
                : throw PointCloudException.Wanted(FailureCode.Unsupported, folder.FolderPath, -1, "points of one picture",
                    "at most " + int.MaxValue / 64, points);
    }
}
