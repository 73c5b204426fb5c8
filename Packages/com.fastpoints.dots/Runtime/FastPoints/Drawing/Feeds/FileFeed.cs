using System;
using System.Collections.Generic;
using FastPoints.Store;
using FastPoints.Streaming;

namespace FastPoints.Drawing
{
    // The states of a cloud that has files and, now or later, a converted folder. The files are shown until the folder exists,
    // which replaces them as it is built. When a build is aborted, the files are shown again.
    internal sealed class FileFeed : CloudFeed
    {
        readonly string m_folder;
        readonly IReadOnlyList<string> m_files;
        readonly Func<IReadOnlyList<string>, CloudFeed> m_open;
        CloudFeed m_source;
        PoolTask<CloudFeed> m_opening;
        FolderFeed m_converted;
        bool m_isSourceWhole;
        bool m_isBuildAborted;

        // Owns both feeds. The folder may not exist, the files may be unknown (empty) and their feed null. open opens the files
        // again, on a pool thread, where a build is gone.
        public FileFeed(string folder, IReadOnlyList<string> files, CloudFeed source, FolderFeed converted,
            Func<IReadOnlyList<string>, CloudFeed> open)
        {
            m_folder = folder;
            m_files = files;
            m_source = source;
            m_converted = converted;
            m_open = open;
        }

        public override CloudFacts Newest => m_converted.Newest ?? m_source?.Newest;

        public override bool IsEnded => m_converted.IsEnded || !m_converted.IsFound && IsIdle;

        internal override bool IsIdle => m_converted.IsIdle && m_opening == null && (m_source == null || m_source.IsIdle);

        public override bool IsBuildAborted => m_isBuildAborted;

        public override NodeSource Take(params string[] planes)
        {
            if (m_converted.Newest == null)
            {
                m_isSourceWhole = m_source.Newest.Stage == CloudStage.Whole;
                return m_source.Take(planes);
            }
            m_isBuildAborted = false;
            if (m_converted.Newest.Stage == CloudStage.Whole)
                EndSource();
            return m_converted.Take(planes);
        }

        public override void Update(double budgetMs)
        {
            m_converted.Update(budgetMs);
            // A source that is streamed directly shows all that a build in progress does.
            if (m_isSourceWhole && m_converted.Newest?.Stage == CloudStage.Building)
                m_converted.Skip();
            if (m_converted.IsBuildAborted && m_converted.IsFound)
                Restart();
            if (m_opening != null && m_opening.IsDone)
                EndOpening();
            if (m_source != null)
                UpdateSource(budgetMs);
        }

        public override void Refresh() => m_converted.Refresh();

        public override void Dispose()
        {
            EndSource();
            m_converted.Dispose();
        }

        void UpdateSource(double budgetMs)
        {
            if (m_converted.IsFound)
                m_source.SkipFullPass();
            try
            {
                m_source.Update(budgetMs);
            }
            catch (PointCloudException) when (m_converted.IsFound)
            {
                // The build's states are shown without the preview.
                EndSource();
            }
        }

        void Restart()
        {
            m_isBuildAborted = true;
            m_isSourceWhole &= m_source != null;
            m_converted.Dispose();
            m_converted = new FolderFeed(new GenerationPoller(m_folder));
            if (m_source == null && m_opening == null && m_files.Count > 0)
                m_opening = PoolTask.Begin(m_files[0], () => m_open(m_files));
        }

        void EndOpening()
        {
            var opened = m_opening;
            m_opening = null;
            m_source = opened.Take();
        }

        void EndSource()
        {
            m_source?.Dispose();
            m_source = null;
            m_opening?.TakeOrDefault()?.Dispose();
            m_opening = null;
        }
    }
}
