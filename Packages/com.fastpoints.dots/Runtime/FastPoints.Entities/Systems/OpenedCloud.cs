using System;
using FastPoints.Drawing;
using FastPoints.Rendering;
using FastPoints.Streaming;
using Unity.Mathematics;

namespace FastPoints.Entities
{
    /// <summary>A cloud's states while its entity exists: opened on a pool thread, so that a slow disk blocks nothing,
    /// then stepped on the main thread.</summary>
    sealed class OpenedCloud : IDisposable
    {
        PoolTask<CloudFeed> m_opening;
        CloudFeed m_feed;
        DisplayRanges m_rangesWithoutOutliers;
        readonly byte[] m_paths;

        public OpenedCloud(in PointCloudFile file, ReadOnlySpan<byte> paths)
        {
            AppliedFile = file;
            m_paths = paths.ToArray();
            var parsed = PointCloudPaths.Of(paths);
            string path = Path = parsed.FullPath;
            string[] sources = parsed.FullSources();
            m_opening = PoolTask.Begin(path, () => CloudFeeds.Open(path, sources));
        }

        public PointCloudFile AppliedFile; // The component's values that are applied: users and live baking change them.

        public string Path { get; }

        public double3 Shift;
        public double3 WorldShift;
        public bool IsOpen => m_opening == null || m_opening.IsDone; // Whether it can be disposed without waiting for a disk.

        /// <summary>Whether updates change nothing until a refresh, or for a second.</summary>
        public bool IsIdle => m_opening == null && (m_feed == null || m_feed.Newest == null && m_feed.IsIdle);

        public bool IsFollowed => m_feed != null && !m_feed.IsEnded;

        public bool IsBuildAborted => m_feed != null && m_feed.IsBuildAborted;

        public CloudFacts Newest => m_feed?.Newest;

        /// <exception cref="PointCloudException">The cloud cannot be opened or read.</exception>
        public void Update(double budgetMs)
        {
            if (m_opening != null && m_opening.IsDone)
            {
                var opened = m_opening;
                m_opening = null;
                m_feed = opened.Take();
            }
            m_feed?.Update(budgetMs);
        }

        /// <summary>Whether it was opened by an equal file, except for its position.</summary>
        public bool Matches(in PointCloudFile file, ReadOnlySpan<byte> paths) =>
            AppliedFile.HasSameOpenSettings(file) && paths.SequenceEqual(m_paths) && !IsLitOtherwise(file);

        // Stored normals are streamed where they are lit.
        bool IsLitOtherwise(in PointCloudFile file) => AppliedFile.Light > 0 != file.Light > 0 && Newest?.HasNormals == true;

        public void Refresh() => m_feed?.Refresh();

        /// <summary>Makes a source of the newest state, with the planes that its colours need and no more.</summary>
        /// <exception cref="PointCloudException">The state cannot be streamed.</exception>
        public (NodeSource Source, PointCloudLook Look, CloudStage Stage) Take(in PointCloudFile file)
        {
            var facts = m_feed.Newest;
            var mode = facts.Ranges.Resolve(file.Color);
            var taken = m_feed.Take(CloudLooks.PlanesFor(mode, !file.HiddenClasses.IsEmpty, file.Light > 0));
            var colors = ColorMapping.Of(mode, RangesFor(facts, file.Color, mode).WithUp(file.Up),
                taken.Grid.TransformFromCorner(taken.Root.Corner), file.ColorRamp);
            var look = new PointCloudLook { Value = CloudLooks.Of(colors, taken, file.HiddenClasses) };
            return (taken, look, facts.Stage);
        }

        /// <summary>Waits for headers being read and for slices that are running.</summary>
        public void Dispose()
        {
            m_feed ??= m_opening?.TakeOrDefault();
            m_opening = null;
            m_feed?.Dispose();
            m_feed = null;
        }

        /// <summary>States after a preview keep its colour ranges, so that colours do not change.</summary>
        DisplayRanges RangesFor(CloudFacts facts, ColorMode wanted, ColorMode mode)
        {
            if (!facts.RangesHaveOutliers)
                m_rangesWithoutOutliers = facts.Ranges;
            bool isKnownBetter = m_rangesWithoutOutliers != null && m_rangesWithoutOutliers.Resolve(wanted) == mode;
            return isKnownBetter ? m_rangesWithoutOutliers : facts.Ranges;
        }
    }
}
