using System.Diagnostics;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Streaming
{
    /// <summary>A frame of streaming, independent of engine and entities: from cameras to the list of what to draw. It waits for
    /// nothing and makes no garbage: work begun in one frame is taken by a later one.</summary>
    public static unsafe class FrameStep
    {
        /// <param name="views">All cameras of the frame.</param>
        public static FrameStats Run(StreamContext stream, NativeArray<StreamView> views)
        {
            var stats = new FrameStats();
            Receive(stream, ref stats);
            Select(stream, views, ref stats);
            Upload(stream, ref stats);
            Request(stream, ref stats);
            List(stream, ref stats);
            return stats;
        }

        /// <summary>Completes nodes whose copies ended, and extends the hierarchy by tables that arrived.</summary>
        public static void Receive(StreamContext stream, ref FrameStats stats)
        {
            long start = Stopwatch.GetTimestamp();
            stream.Pool.BeginFrame();
            stream.Uploads.EndIfCompleted(ref stats);
            stream.Trim();
            stream.UpdateSources();
            stream.Reads.Receive(ref stats);
            stats.ReceiveMs = MsSince(start);
        }

        /// <summary>Chooses what the cameras need now, and what they will need soon.</summary>
        public static void Select(StreamContext stream, NativeArray<StreamView> views, ref FrameStats stats)
        {
            long start = Stopwatch.GetTimestamp();
            var selector = stream.Selector;
            var settings = stream.Settings;
            selector.Begin(stream.ClipBoxes.AsArray());
            for (int c = 0; c < stream.Clouds.Count; c++)
            {
                var cloud = stream.Clouds[c];
                if (cloud != null && !cloud.IsRemoving)
                    selector.Add(c, cloud.Pages, cloud.Placement, cloud.Source.Cubes.Size, cloud.IsReplacement);
            }
            selector.Select(views, settings.Selection);
            if (stream.Motion.RecordAndTryPredict(views, stream.FramesToPredict))
                selector.Prefetch(stream.Motion.Predicted, settings.Selection, stream.PointsToPrefetch);
            Touch(stream);
            stats.Frame = selector.Frame;
            stats.SelectedNodes = selector.Selected.Length;
            stats.SelectedPoints = selector.Points;
            stats.MissingPages = selector.Missing.Length;
            stats.SelectMs = MsSince(start);
        }

        internal static void Touch(StreamContext stream) => new TouchNodesJob
        {
            Clouds = stream.CloudPages,
            Drawn = stream.Drawn.AsArray().GetSubArray(0, stream.Settings.FadeSeconds > 0 ? stream.Drawn.Length : 0),
            Selected = stream.Selector.Selected,
            Prefetched = stream.Selector.Prefetched,
            Pinned = stream.Cache.Pinned,
            Frame = stream.Selector.Frame,
            Order = stream.Cache.Order,
        }.Run();

        /// <summary>Begins to copy what has arrived.</summary>
        public static void Upload(StreamContext stream, ref FrameStats stats)
        {
            long start = Stopwatch.GetTimestamp();
            stream.Uploads.Begin(stream.Reads.Fetches);
            // This also starts building what was received: otherwise both would begin with the next frame.
            JobHandle.ScheduleBatchedJobs();
            stats.UploadMs = MsSince(start);
        }

        /// <summary>Begins reads of missing nodes and evicts nodes of lower rank.</summary>
        public static void Request(StreamContext stream, ref FrameStats stats)
        {
            long start = Stopwatch.GetTimestamp();
            stream.Reads.Request(ref stats);
            // Nodes that are made would else begin with the next frame.
            JobHandle.ScheduleBatchedJobs();
            stats.RequestMs = MsSince(start);
        }

        /// <summary>Lists what to draw.</summary>
        public static void List(StreamContext stream, ref FrameStats stats)
        {
            long start = Stopwatch.GetTimestamp();
            new ListDrawnJob
            {
                Clouds = stream.CloudPages,
                Selected = stream.Selector.Selected,
                Nodes = stream.Cache.Nodes,
                Frame = stream.Selector.Frame,
                FadeStep = stream.Settings.FadeSeconds > 0 ? stream.FrameSeconds / stream.Settings.FadeSeconds : 1,
                PointBudget = stream.Settings.Selection.PointBudget,
                Drawn = stream.Drawn,
                LastDrawn = stream.LastDrawn,
                DrawnOfSelected = stream.DrawnOfSelected,
                Totals = stream.DrawnTotals,
            }.Run();
            var totals = stream.DrawnTotals.Value;
            stats.DrawnNodes = stream.Drawn.Length;
            stats.DrawnPoints = totals.Points;
            stats.FadingNodes = totals.FadingNodes;
            stats.CachedNodes = stream.Cache.Count;
            stats.PoolBytes = stream.Pool.AllocatedBytes;
            stats.HierarchyBytes = stream.HierarchyBytes;
            stats.ReadsInFlight = stream.Reads.InFlightCount;
            stats.IsSettled = totals.IsAll && totals.FadingNodes == 0 && stats.ReadsInFlight == 0 &&
                !stream.Uploads.IsInFlight && !stream.IsRemovingAny && stream.Selector.Missing.Length == 0;
            stats.ListMs = MsSince(start);
        }

        static double MsSince(long start) => (Stopwatch.GetTimestamp() - start) * 1000.0 / Stopwatch.Frequency;
    }
}
