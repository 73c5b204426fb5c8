using System;
using System.Collections.Generic;
using FastPoints.Store;
using Unity.Mathematics;

namespace FastPoints.Export
{
    /// <summary>Edits converted clouds from code, and exports them as edited, in coroutines for a
    /// <see cref="JobCoroutine"/>. They throw a <see cref="PointCloudException"/> if that cannot be done.</summary>
    public static class PointCloudEdits
    {
        /// <summary>Deletes the points in a box.</summary>
        /// <param name="box">Georeferenced, in CRS units.</param>
        /// <param name="done">Receives how many points.</param>
        public static IEnumerator<JobStep> DeleteIn(string cloud, BoundsGeo box, Action<long> done) =>
            Edit(cloud, new EditOperation { Action = EditAction.Delete }, (o, grid) => AddBox(o, grid, box), done);

        /// <summary>Gives the points in a box a class.</summary>
        /// <param name="box">Georeferenced, in CRS units.</param>
        /// <param name="done">Receives how many points had another.</param>
        public static IEnumerator<JobStep> ClassifyIn(string cloud, BoundsGeo box, byte classification, Action<long> done) =>
            Edit(cloud, new EditOperation { Action = EditAction.Classify, Value = new[] { classification } },
                (o, grid) => AddBox(o, grid, box), done);

        /// <summary>Deletes the points that an eye sees through a polygon, as if nothing hid them: a lasso on a screen.</summary>
        /// <param name="eye">Georeferenced, in CRS units, as all positions; far away for a parallel view.</param>
        /// <param name="corners">A position on the ray through each corner.</param>
        /// <param name="done">Receives how many points.</param>
        public static IEnumerator<JobStep> DeleteInLasso(string cloud, double3 eye, double3[] corners, Action<long> done) =>
            Edit(cloud, new EditOperation { Action = EditAction.Delete },
                (o, grid) => o.SetLasso(grid, new double4(eye, 1), corners), done);

        /// <summary>Undoes the last edit.</summary>
        /// <param name="done">Receives whether there was one.</param>
        public static IEnumerator<JobStep> Undo(string cloud, Action<bool> done) => PoolTask.Run(cloud, () =>
        {
            int count = EditCloud.GoTo(cloud, -1);
            return count > 0 && EditCloud.GoTo(cloud, count - 1) < count;
        }, done);

        /// <summary>Writes a cloud as edited to a file.</summary>
        /// <param name="path">Ends in .las, .laz or .ply.</param>
        /// <param name="done">Receives how many points it has.</param>
        public static IEnumerator<JobStep> Export(string cloud, string path, Action<long> done)
        {
            ConvertedReader reader = null;
            try
            {
                yield return JobStep.Of(PoolTask.Run(cloud, () => ConvertedReader.OpenEdited(cloud), opened => reader = opened,
                    unwanted => unwanted.DisposeUnread()));
                yield return JobStep.Of(ExportCloud.Run(reader, path, new ExportSettings(), result => done(result.Points), null));
            }
            finally
            {
                reader?.Dispose();
            }
        }

        static string AddBox(EditOperation operation, CloudGrid grid, BoundsGeo box)
        {
            operation.Boxes.Add(EditShape.Box(grid, box.Min, box.Max));
            return null;
        }

        static IEnumerator<JobStep> Edit(string cloud, EditOperation operation, Func<EditOperation, CloudGrid, string> choose,
            Action<long> done)
        {
            CloudManifest manifest = null;
            yield return JobStep.Of(PoolTask.Run(cloud, () =>
            {
                using var folder = CloudFolder.Open(cloud);
                return folder.Manifest;
            }, read => manifest = read));
            operation.CloudId = manifest.CloudId;
            if (choose(operation, manifest.Grid) is string problem)
                throw new PointCloudException(FailureCode.Unsupported, cloud, -1, problem);
            yield return JobStep.Of(EditCloud.Run(cloud, operation, null));
            done(operation.PointsChanged);
        }
    }
}
