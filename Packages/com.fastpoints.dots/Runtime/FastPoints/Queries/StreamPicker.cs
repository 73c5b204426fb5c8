using System;
using System.Collections.Generic;
using FastPoints.Drawing;
using FastPoints.Store;
using FastPoints.Streaming;

namespace FastPoints.Queries
{
    /// <summary>Finds the first point that a ray hits among all clouds of a stream, beside its frames: <see cref="Begin"/>,
    /// then <see cref="Update"/> once a frame until it returns true. Main thread; it waits only when a search is
    /// cancelled.</summary>
    internal sealed class StreamPicker : IDisposable
    {
        struct Target
        {
            public int Cloud;
            public NodeSource Source; // May have been disposed since.
            public CloudPlacement Placement;
            public ClassMask HiddenClasses;
        }

        readonly Dictionary<NodeSource, PointPicker> m_pickers = new Dictionary<NodeSource, PointPicker>();
        readonly List<Target> m_targets = new List<Target>();
        readonly PickOptions m_options = new PickOptions();
        int m_target;
        JobCoroutine m_opening;
        NodeSource m_opened;
        JobCoroutine m_search;
        PickResult m_found;
        PointQuery m_ray;

        /// <summary>Result of the search that was begun last; complete when that is done.</summary>
        public StreamPick Pick { get; private set; } = new StreamPick();

        public bool IsSearching { get; private set; }

        /// <summary>Begins a search of all clouds, or of those that are to be searched; a search in progress is cancelled.
        /// Points of hidden classes are not hit. Both functions take a cloud's number.</summary>
        public void Begin(StreamContext stream, PointQuery ray, Func<int, ClassMask> hiddenOf = null,
            Func<int, bool> isSearched = null)
        {
            Abort();
            m_ray = ray;
            m_targets.Clear();
            m_target = 0;
            Pick = new StreamPick();
            m_options.ClipBoxes.Clear();
            foreach (var box in stream.ClipBoxes.AsArray())
                m_options.ClipBoxes.Add(box);
            var removed = new List<NodeSource>(m_pickers.Keys);
            for (int c = 0; c < stream.Clouds.Count; c++)
            {
                var cloud = stream.Clouds[c];
                if (cloud == null || cloud.IsRemoving || cloud.IsReplacement || !ray.Mask.Shows(cloud.Placement.Visibility) ||
                    isSearched != null && !isSearched(c))
                    continue;
                m_targets.Add(new Target
                {
                    Cloud = c,
                    Source = cloud.Source,
                    Placement = cloud.Placement,
                    HiddenClasses = hiddenOf != null ? hiddenOf(c) : default,
                });
                removed.Remove(cloud.Source);
            }
            foreach (var source in removed)
            {
                m_pickers[source].Dispose();
                m_pickers.Remove(source);
            }
            IsSearching = true;
        }

        /// <summary>Continues the search once a frame. Returns whether it is done, and <see cref="Pick"/> its result.</summary>
        public bool Update(double budgetMs = 1)
        {
            while (IsSearching)
            {
                if (m_target == m_targets.Count)
                {
                    IsSearching = false;
                    break;
                }
                try
                {
                    if (!Step(m_targets[m_target], budgetMs))
                        break;
                }
                catch (PointCloudException e)
                {
                    Pick.Failure ??= e.Message;
                    m_opening = null;
                    m_search = null;
                }
                m_target++;
            }
            return !IsSearching;
        }

        public void Dispose()
        {
            Abort();
            foreach (var picker in m_pickers.Values)
                picker.Dispose();
            m_pickers.Clear();
        }

        // Whether the cloud is done.
        bool Step(in Target target, double budgetMs)
        {
            if (!m_pickers.TryGetValue(target.Source, out var picker))
            {
                if (!TryOpen(target.Source, budgetMs))
                    return false;
                // The cloud was removed meanwhile.
                if (m_opened == null)
                    return true;
                picker = new PointPicker(m_opened);
                m_opened = null;
                m_pickers.Add(target.Source, picker);
            }
            if (m_search == null)
            {
                m_options.HiddenClasses = target.HiddenClasses;
                m_found = new PickResult();
                var placement = target.Placement.ForVersion(target.Source, picker.Source);
                m_search = new JobCoroutine(picker.Find(m_ray, placement, m_options, m_found));
            }
            if (!m_search.Tick(budgetMs))
                return false;
            m_search = null;
            Pick.IsPartial |= m_found.IsPartial;
            if (m_found.Point != null && (Pick.Point == null || m_found.Point.Distance < Pick.Point.Distance))
                Take(target, picker.Source);
            return true;
        }

        // Whether m_opened is ready, or will never be.
        bool TryOpen(NodeSource streamed, double budgetMs)
        {
            m_opening ??= new JobCoroutine(streamed.OpenForPicking(opened => m_opened = opened));
            if (!m_opening.Tick(budgetMs))
                return false;
            m_opening = null;
            return true;
        }

        void Take(in Target target, NodeSource source)
        {
            Pick.Point = m_found.Point;
            Pick.Cloud = target.Cloud;
            Pick.Path = StoreFormat.FinishedPath(source.Path);
            Pick.Crs = source.Crs;
            Pick.Units = source.Crs.Units;
            Pick.IsPreview = !source.HasAllPoints;
            // Later hits have to be nearer.
            m_ray.To = m_found.Point.Distance;
        }

        void Abort()
        {
            m_search?.Cancel();
            m_search = null;
            m_opening?.Cancel();
            m_opening = null;
            IsSearching = false;
        }
    }

    /// <summary>What a ray has hit among the clouds of a stream.</summary>
    public sealed class StreamPick
    {
        /// <summary>Null if nothing was hit.</summary>
        public PickedPoint Point { get; internal set; }

        /// <summary>Number of the point's cloud in the stream, as it was when the search began.</summary>
        public int Cloud { get; internal set; }

        /// <summary>A converted folder, without the suffix of an unfinished one; or a file.</summary>
        public string Path { get; internal set; }

        /// <summary>Units and coordinate system of the point's cloud.</summary>
        public CloudCrs Crs { get; internal set; }

        /// <summary>As the cloud says, unless overridden.</summary>
        public CloudUnits Units { get; set; }

        /// <summary>The axis of the cloud that points up: Z, unless it is overridden.</summary>
        public UpAxis Up { get; set; } = UpAxis.Z;

        /// <summary>A preview or a build in progress: not all of the cloud's points could be hit.</summary>
        public bool IsPreview { get; internal set; }

        /// <summary>Whether a search ended before it had covered everything, so that there may be a nearer point.</summary>
        public bool IsPartial { get; internal set; }

        /// <summary>The message of the first cloud that could not be searched; null if all could.</summary>
        public string Failure { get; internal set; }
    }
}
