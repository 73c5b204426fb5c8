using System;
using System.Collections.Generic;
using FastPoints.Build;
using FastPoints.Reading;
using FastPoints.Store;
using Unity.Jobs;

namespace FastPoints.Export
{
    /// <summary>Changes the edits of a converted cloud, one process at a time; the cloud stays as it is.</summary>
    internal static class EditCloud
    {
        const string LockSuffix = ".lock";

        /// <summary>Coroutine: counts the points that an operation changes, and writes it down if there are any.</summary>
        /// <exception cref="PointCloudException">The cloud cannot be edited like that, or somebody else edits it.</exception>
        public static IEnumerator<JobStep> Run(string cloud, EditOperation operation, StageProgress progress)
        {
            FolderLock held = null;
            ConvertedReader reader = null;
            try
            {
                yield return JobStep.Of(PoolTask.Run(cloud, () => Lock(cloud), taken => held = taken,
                    unwanted => unwanted.Dispose()));
                yield return JobStep.Of(PoolTask.Run(cloud, () => ConvertedReader.OpenEdited(cloud, operation),
                    opened => reader = opened, unwanted => unwanted.DisposeUnread()));
                var ranges = new List<BlockRange>();
                int longest = 1;
                for (int block = 0; block < reader.BlockCount; block++)
                    if (reader.Edits.MayReach(reader.NodeOf(block).Cube))
                    {
                        ranges.Add(new BlockRange(block, 0, reader.PointsInBlock(block)));
                        longest = Math.Max(longest, reader.PointsInBlock(block));
                    }
                progress?.Begin("count");
                var wanted = reader.Info.Schema.Select(AttributeNames.X, AttributeNames.Y, AttributeNames.Z);
                yield return JobStep.Of(SourceScan.Run(ScanRanges.Of(reader, ranges, longest), wanted, new Nobody(),
                    SourceScan.LimitFor(reader, wanted, 0, SourceScan.MaxSlotBytes, 0, () => 0), 0, progress));
                progress?.End();
                operation.PointsChanged = reader.Edits.PointsChanged[^1];
                ulong id = reader.Manifest.CloudId;
                if (operation.PointsChanged > 0)
                    yield return JobStep.Of(PoolTask.Run(cloud, () => Write(cloud, id, operation), _ => { }));
            }
            finally
            {
                reader?.Dispose();
                held?.Dispose();
            }
        }

        /// <summary>Undoes the last operation, or does it again. Not for a main thread.</summary>
        /// <returns>The operation; null if there is none.</returns>
        public static EditOperation Step(string cloud, ulong cloudId, bool isUndo)
        {
            using var held = Lock(cloud);
            var journal = EditJournal.Read(cloud, cloudId);
            return isUndo ? journal.TryUndo() ? journal.Operations[journal.Count] : null
                : journal.TryRedo() ? journal.Operations[journal.Count - 1] : null;
        }

        /// <summary>Undoes, or does again, until so many operations are applied. Not for a main thread.</summary>
        /// <param name="count">Negative to change nothing.</param>
        /// <returns>How many are: fewer if there are no more.</returns>
        public static int GoTo(string cloud, int count)
        {
            ulong id;
            using (var folder = CloudFolder.Open(cloud))
                id = folder.Manifest.CloudId;
            using var held = Lock(cloud);
            var journal = EditJournal.Read(cloud, id);
            while (count >= 0 && journal.Count > count && journal.TryUndo()) { }
            while (journal.Count < count && journal.TryRedo()) { }
            return journal.Count;
        }

        static bool Write(string cloud, ulong cloudId, EditOperation operation)
        {
            EditJournal.Read(cloud, cloudId).Add(operation);
            return true;
        }

        static FolderLock Lock(string cloud)
        {
            if (SourcePath.IsRemote(cloud))
                throw new PointCloudException(FailureCode.Unsupported, cloud, -1, "a cloud on a server cannot be edited");
            string path = System.IO.Path.GetFullPath(EditJournal.PathOf(cloud));
            return FolderLock.TryTake(path + LockSuffix, out var taken) is string owner
                ? throw new PointCloudException(FailureCode.WriteFailed, path, -1, "is being written by " + owner) : taken;
        }

        /// <summary>Whoever reads counts.</summary>
        sealed class Nobody : IBlockConsumer
        {
            public JobHandle Schedule(BlockRead read, int slot, JobHandle decoded) => decoded;

            public void Completed(BlockRead read, int slot) { }
        }
    }
}
