using System;
using System.Collections.Generic;
using System.Threading.Tasks;
using FastPoints.Base;
using FastPoints.Gpu;
using FastPoints.Store;
using FastPoints.Streaming;

namespace FastPoints.Picking
{
    /// <summary>
    /// Finds the first point that a ray hits of all clouds of a stream, beside its frames: <see cref="Begin"/>, then
    /// <see cref="Update"/> once a frame until that says it is done. Looks at converted clouds, whole or in the making; others
    /// are passed over. Main thread; waits only where a search is broken off.
    /// </summary>
    public sealed class StreamPicker : IDisposable
    {
        struct Target
        {
            public int Cloud;
            public string Path;
            public CloudPlacement Placement;
            public ClassMask HiddenClasses;
        }

        readonly Dictionary<string, PointPicker> m_pickers = new Dictionary<string, PointPicker>();
        readonly List<Target> m_targets = new List<Target>();
        readonly PickOptions m_options = new PickOptions();
        int m_target;
        Task<FolderSource> m_opening;
        WorkPump m_search;
        PickResult m_found;
        PickRay m_ray;

        /// <summary>Of the search that was begun last; whole when that is done.</summary>
        public StreamPick Pick { get; private set; } = new StreamPick();

        public bool IsSearching { get; private set; }

        /// <summary>Looks at the clouds as they are now; a search that goes on is broken off.</summary>
        /// <param name="hiddenOf">By number of a cloud, classes whose points are not shown; null for none.</param>
        public void Begin(StreamContext stream, PickRay ray, Func<int, ClassMask> hiddenOf = null)
        {
            BreakOff();
            m_ray = ray;
            m_targets.Clear();
            m_target = 0;
            Pick = new StreamPick();
            m_options.ClipBoxes.Clear();
            foreach (var box in stream.ClipBoxes.AsArray())
                m_options.ClipBoxes.Add(box);
            var gone = new List<string>(m_pickers.Keys);
            for (int c = 0; c < stream.Clouds.Count; c++)
            {
                var cloud = stream.Clouds[c];
                if (cloud == null || cloud.IsLeaving || !(cloud.Source is FolderSource source))
                    continue;
                m_targets.Add(new Target
                {
                    Cloud = c,
                    Path = source.Path,
                    Placement = cloud.Placement,
                    HiddenClasses = hiddenOf != null ? hiddenOf(c) : default,
                });
                if (m_pickers.TryGetValue(source.Path, out var picker) && IsSame(picker.Source, source))
                    gone.Remove(source.Path);
            }
            foreach (string path in gone)
            {
                m_pickers[path].Dispose();
                m_pickers.Remove(path);
            }
            IsSearching = true;
        }

        /// <summary>Once a frame.</summary>
        /// <param name="budgetMs">Of the main thread.</param>
        /// <returns>Whether the search is done, and <see cref="Pick"/> its result.</returns>
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
                    m_search = null;
                }
                m_target++;
            }
            return !IsSearching;
        }

        public void Dispose()
        {
            BreakOff();
            foreach (var picker in m_pickers.Values)
                picker.Dispose();
            m_pickers.Clear();
        }

        /// <returns>Whether the cloud is done.</returns>
        bool Step(in Target target, double budgetMs)
        {
            if (m_search == null)
            {
                if (!TryOpen(target.Path, out var picker))
                    return false;
                m_options.HiddenClasses = target.HiddenClasses;
                m_found = new PickResult();
                m_search = new WorkPump(picker.Find(m_ray, target.Placement, m_options, m_found));
            }
            if (!m_search.Tick(budgetMs))
                return false;
            m_search = null;
            Pick.IsPartial |= m_found.IsPartial;
            if (m_found.Point == null || (Pick.Point != null && m_found.Point.Distance >= Pick.Point.Distance))
                return true;
            Pick.Point = m_found.Point;
            Pick.Cloud = target.Cloud;
            Pick.Manifest = ((FolderSource)m_pickers[target.Path].Source).Folder.Manifest;
            // What comes after it has to be nearer.
            m_ray.To = m_found.Point.Distance;
            return true;
        }

        bool TryOpen(string path, out PointPicker picker)
        {
            if (m_pickers.TryGetValue(path, out picker))
                return true;
            m_opening ??= Task.Run(() => PointPicker.Open(path));
            if (!m_opening.IsCompleted)
                return false;
            var opened = m_opening;
            m_opening = null;
            picker = new PointPicker(opened.GetAwaiter().GetResult());
            m_pickers.Add(path, picker);
            return true;
        }

        void BreakOff()
        {
            m_search?.Cancel();
            m_search = null;
            m_opening?.ContinueWith(t => t.Result.Dispose(), TaskContinuationOptions.OnlyOnRanToCompletion);
            m_opening = null;
            IsSearching = false;
        }

        /// <summary>Whether a folder is still what it was when it was opened: not another generation, not converted
        /// again.</summary>
        static bool IsSame(NodeSource opened, FolderSource streamed)
        {
            CloudManifest a = ((FolderSource)opened).Folder.Manifest, b = streamed.Folder.Manifest;
            return a.CloudId == b.CloudId && a.Generation == b.Generation && a.IsBuilding == b.IsBuilding;
        }
    }
}
