using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Threading;

namespace FastPoints.Editor
{
    /// <summary>Converts in batch mode, which has no editor updates.</summary>
    public static class BatchConvert
    {
        /// <summary>Converts every cloud of the project's assets that is not converted yet, and returns when all are. For
        /// <c>Unity -batchmode -quit -projectPath PROJECT -executeMethod FastPoints.Editor.BatchConvert.All</c>.</summary>
        /// <exception cref="InvalidOperationException">Some could not be converted: Unity ends with exit code 1.</exception>
        public static void All()
        {
            var imports = PointCloudImports.Current;
            imports.PointFilePrompt.AddExisting();
            Convert(imports, new List<string>(imports.Assets.All.Keys));
        }

        internal static void Convert(EditorImports imports, IEnumerable<string> assets)
        {
            int count = 0;
            imports.Catalog.Refresh();
            var failed = new List<string>();
            var requests = new List<ImportRequest>();
            foreach (string asset in assets)
            {
                if (!imports.Assets.All.ContainsKey(asset))
                    continue;
                count++;
                if (TryRequest(imports, asset, failed) is { } request)
                    requests.Add(request);
            }
            imports.Queue.Add(requests);
            for (var stopped = Stopwatch.StartNew(); imports.Queue.HasWork || imports.HasPendingWrites;)
            {
                imports.Update(DateTime.UtcNow);
                if (imports.Queue.Session != null || imports.Queue.Problem == null)
                    stopped.Restart();
                // Momentary refusals, as by a virus scanner, are retried.
                else if (stopped.ElapsedMilliseconds > FileChanges.RetryTimeoutMs)
                    throw new InvalidOperationException("FastPoints: " + imports.Queue.Problem);
                // Workers need the core more than this loop does.
                Thread.Sleep(1);
            }
            FileChanges.AwaitDeletes();
            foreach (var request in requests)
                if (request.State == ImportState.Failed)
                    failed.Add(request.Failure);
            if (failed.Count > 0)
                throw new InvalidOperationException("FastPoints: " + failed.Count + " of " + count +
                    " point clouds were not converted:\n" + string.Join("\n", failed));
        }

        /// <returns>Null for a converted or directly shown cloud, and for a handle that cannot be read.</returns>
        static ImportRequest TryRequest(EditorImports imports, string asset, List<string> failed)
        {
            try
            {
                var handle = imports.HandleOf(asset);
                return imports.ShouldConvert(handle) && imports.Catalog.Find(handle, out _) != CatalogMatch.InPlace
                    ? imports.RequestFor(asset, handle) : null;
            }
            catch (PointCloudException e)
            {
                failed.Add(e.Message);
                return null;
            }
        }
    }
}
