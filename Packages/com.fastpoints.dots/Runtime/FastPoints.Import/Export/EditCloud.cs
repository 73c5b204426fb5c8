using System;
using System.Collections.Generic;
using FastPoints.Build;
using FastPoints.Reading;
using FastPoints.Store;
using Unity.Jobs;

namespace FastPoints.Export
{
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
                var ranges = new List<BlockRange>();
                yield return JobStep.Of(PoolTask.Run(cloud, () => OpenAndChoose(cloud, operation, ranges),
                    opened => reader = opened, unwanted => unwanted.DisposeUnread()));
                long known = operation.PointsChanged;
                progress?.Begin("count");
                var wanted = reader.Info.Schema.Select(AttributeNames.X, AttributeNames.Y, AttributeNames.Z);
                var scanned = ScanRanges.Of(reader, ranges, Math.Max(1, reader.MaxPointsPerBlock));
                yield return JobStep.Of(SourceScan.Run(scanned, wanted, new Nobody(),
                    SourceScan.LimitFor(reader, wanted, 0, SourceScan.MaxSlotBytes, 0, () => 0), 0, progress));
                progress?.End();
                operation.PointsChanged = known + reader.Edits.PointsChanged[^1];
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

        // Lists what has to be looked at: all points of other nodes are changed, which are counted, or none.
        static ConvertedReader OpenAndChoose(string cloud, EditOperation operation, List<BlockRange> ranges)
        {
            var reader = ConvertedReader.OpenEdited(cloud, operation);
            operation.PointsChanged = 0;
            for (int block = 0; block < reader.BlockCount; block++)
            {
                var reach = reader.Edits.ReachOf(reader.NodeOf(block));
                if (reach == EditReach.All)
                    operation.PointsChanged += reader.PointsInBlock(block);
                else if (reach == EditReach.Some)
                    ranges.Add(new BlockRange(block, 0, reader.PointsInBlock(block)));
            }
            return reader;
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

        public static FolderLock Lock(string cloud)
        {
            if (SourcePath.IsRemote(cloud))
                throw new PointCloudException(FailureCode.Unsupported, cloud, -1, "a cloud on a server cannot be edited");
            string path = System.IO.Path.GetFullPath(EditJournal.PathOf(cloud));
            return FolderLock.TakeOrGetOwner(path + LockSuffix, out var taken) is string owner
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
