using System.Diagnostics;
using Unity.Collections;

namespace FastPoints.Streaming
{
    /// <summary>
    /// A frame of streaming, without engine and without entities: from cameras to the list of what to draw. Waits for nothing and
    /// makes no garbage: what a step begins, a later frame's step takes.
    /// </summary>
    public static unsafe class FrameStep
    {
        /// <param name="views">All cameras of the frame.</param>
        public static FrameStats Run(StreamContext stream, NativeArray<StreamView> views)
        {
            var stats = new FrameStats();
            long start = Stopwatch.GetTimestamp();

            stream.Pool.BeginFrame();

            // Copies that ended make nodes complete, tables that came make the hierarchy grow.
            stream.Uploads.TryEnd(ref stats);
            stream.TidyUp();
            stream.UpdateSources();
            stream.Reads.Receive(ref stats);
            stats.ReceiveMs = Lap(ref start);

            Select(stream, views, ref stats);
            stats.SelectMs = Lap(ref start);

            stream.Uploads.Begin(stream.Reads.Fetches);
            stats.UploadMs = Lap(ref start);

            // Evicts what is less useful than what it asks for.
            stream.Reads.Request(ref stats);
            stats.RequestMs = Lap(ref start);

            ListDraws(stream, ref stats);
            stats.ListMs = Lap(ref start);
            return stats;
        }

        static void Select(StreamContext stream, NativeArray<StreamView> views, ref FrameStats stats)
        {
            var selector = stream.Selector;
            var settings = stream.Settings;
            selector.Begin();
            for (int c = 0; c < stream.Clouds.Count; c++)
            {
                var cloud = stream.Clouds[c];
                if (cloud != null && !cloud.IsLeaving)
                    selector.Add(c, cloud.Pages, cloud.Placement);
            }
            selector.Choose(views, settings.Selection);
            if (stream.Motion.TryForesee(views, settings.FramesAhead))
                selector.Forecast(stream.Motion.Ahead, settings.Selection,
                    (long)(settings.Selection.PointBudget * settings.ShareAhead));

            // From the least needed to the most: that is the order in which the cache gives up.
            Use(stream, selector.Forecasted, StreamContext.FirstForecastRank);
            Use(stream, selector.Selected, 0);
            stats.Frame = selector.Frame;
            stats.SelectedNodes = selector.Selected.Length;
            stats.SelectedPoints = selector.Points;
            stats.MissingPages = selector.Missing.Length;
        }

        static void Use(StreamContext stream, NativeArray<SelectedNode> nodes, int firstRank)
        {
            for (int i = nodes.Length - 1; i >= 0; i--)
            {
                var node = nodes[i];
                int slot = stream.Clouds[node.Cloud].Pages[node.Page].States[node.Node].Slot;
                if (slot != NodeState.NoSlot)
                    stream.Cache.Use(slot, stream.Selector.Frame, firstRank + i);
            }
        }

        /// <summary>What is complete, with all above it. A hole hides nothing but itself.</summary>
        static void ListDraws(StreamContext stream, ref FrameStats stats)
        {
            var selected = stream.Selector.Selected;
            var isShown = stream.IsShown;
            var drawn = stream.Drawn;
            isShown.Clear();
            drawn.Clear();
            bool isAll = true;
            for (int i = 0; i < selected.Length; i++)
            {
                var node = selected[i];
                var page = stream.Clouds[node.Cloud].Pages + node.Page;
                var state = page->States + node.Node;
                bool isParentShown = node.Parent < 0 || isShown[node.Parent];
                bool isHole = state->Slot == NodeState.NoSlot && page->IsHole(node.Node);
                bool isComplete = state->Slot != NodeState.NoSlot && stream.Cache[state->Slot].Phase == CachePhase.Resident;
                isShown.Add(isParentShown && (isHole || isComplete));
                isAll &= isHole || isComplete;
                if (!isParentShown || !isComplete)
                    continue;
                drawn.Add(new DrawnNode
                {
                    Cloud = node.Cloud,
                    Page = node.Page,
                    Node = node.Node,
                    Run = stream.Cache[state->Slot].Run,
                });
                stats.DrawnPoints += page->Nodes[node.Node].PointCount;
            }
            stats.DrawnNodes = drawn.Length;
            stats.CachedNodes = stream.Cache.Count;
            stats.PoolBytes = stream.Pool.AllocatedBytes;
            stats.HierarchyBytes = stream.HierarchyBytes;
            stats.ReadsUnderWay = stream.Reads.UnderWay;
            stats.IsSettled = isAll && stats.ReadsUnderWay == 0 && !stream.Uploads.IsUnderWay && !stream.HasLeaving &&
                stream.Selector.Missing.Length == 0;
        }

        /// <summary>Milliseconds since the last lap.</summary>
        static double Lap(ref long start)
        {
            long now = Stopwatch.GetTimestamp();
            double ms = (now - start) * 1000.0 / Stopwatch.Frequency;
            start = now;
            return ms;
        }
    }
}
