using FastPoints.Store;
using FastPoints.Streaming;

namespace FastPoints.Drawing
{
    // The states of a converted cloud: the finished one, or the generations of a build in progress, which this feed owns.
    internal sealed class FolderFeed : CloudFeed
    {
        readonly GenerationPoller m_generations;
        CloudFacts m_facts;
        CloudFolder m_described;

        public FolderFeed(GenerationPoller generations) => m_generations = generations;

        public override CloudFacts Newest
        {
            get
            {
                if (m_described != m_generations.Newest)
                {
                    m_described = m_generations.Newest;
                    m_facts = m_described != null ? Describe(m_described) : null;
                }
                return m_facts;
            }
        }

        public bool IsFound => m_generations.IsFound; // A state was found and still exists.

        public override bool IsEnded => !m_generations.IsFollowing && IsIdle;
        internal override bool IsIdle => m_generations.IsIdle;
        public override bool IsBuildAborted => m_generations.IsDeleted;

        public override NodeSource Take(params string[] planes) =>
            new FolderSource(m_generations.Take(), planes)
            {
                MarkedStale = m_generations.MarkStale,
                Edits = m_generations.Edits,
                Refused = m_generations.Refused,
            };

        public void Skip() => m_generations.Take()?.Dispose();

        public override void Update(double budgetMs) => m_generations.Update();

        public override void Refresh() => m_generations.Refresh();

        public override void Dispose() => m_generations.Dispose();

        static CloudFacts Describe(CloudFolder folder) => new CloudFacts
        {
            Stage = folder.IsUnfinished ? CloudStage.Building : CloudStage.Whole,
            BoundsGeo = folder.Manifest.BoundsGeo,
            Units = folder.Manifest.Crs.Units,
            Ranges = DisplayRanges.Of(folder.Manifest),
            RangesHaveOutliers = folder.Manifest.DisplayRanges == null,
            HasNormals = folder.Layout.ComputedPlaneCount > 0,
        };
    }
}
