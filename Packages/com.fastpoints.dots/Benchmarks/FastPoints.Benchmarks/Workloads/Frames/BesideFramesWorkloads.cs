using System;
using System.Collections.Generic;
using FastPoints.Base;
using FastPoints.Draw;
using FastPoints.Files;
using FastPoints.SourceFeeds;
using FastPoints.Verify;

namespace FastPoints.Benchmarks
{
    /// <summary>Work that a pump steps beside frames: alone, at 60 Hz, and at 10 Hz, as an editor without focus has. The error is
    /// how long frames wait for their own jobs; the note has the shares of the speed alone, and the ticks.</summary>
    public abstract class BesideFramesWorkload : IWorkload
    {
        public abstract string Name { get; }
        public string LimitName => null;

        /// <summary>Main-thread time of the work in a frame.</summary>
        protected abstract double TickMs { get; }

        /// <summary>Points of one run; 0 where there is no input.</summary>
        protected abstract long Points { get; }

        public abstract void Prepare(WorkloadContext context);

        public WorkloadResult Run()
        {
            if (Points == 0)
                return default;
            using (var frames = new FrameLoop(TickMs))
            {
                string note = frames.Compare(Begin);
                return new WorkloadResult { Points = 3 * Points, Error = frames.WaitMs, ErrorUnit = "ms p99 wait", Note = note };
            }
        }

        public void Dispose()
        {
        }

        /// <summary>Makes the work once more.</summary>
        protected abstract IEnumerator<Work> Begin();
    }

    /// <summary>A converted cloud is verified.</summary>
    public sealed class BesideVerifyWorkload : BesideFramesWorkload
    {
        string m_cloud;
        WorkloadContext m_context;

        public override string Name => "frame beside verify";
        protected override double TickMs => 4;
        protected override long Points => m_context.Points;

        public override void Prepare(WorkloadContext context)
        {
            m_context = context;
            m_cloud = TerrainBenchmarkFile.MakeConverted(context);
        }

        protected override IEnumerator<Work> Begin()
        {
            var result = new VerifyResult();
            yield return Work.Of(VerifyCloud.Run(m_cloud, Array.Empty<PointReader>(), result, null));
            if (!result.Ok)
                throw new InvalidOperationException(result.Problems[0]);
        }
    }

    /// <summary>A file's preview is taken, as a scene takes it.</summary>
    public abstract class BesidePreviewWorkload : BesideFramesWorkload
    {
        string m_path;

        protected override double TickMs => 2;
        protected override long Points => m_path == null ? 0 : SourceFeed.PreviewPoints;

        public override void Prepare(WorkloadContext context) => m_path = Find(context);

        /// <returns>The file's path; null where there is none.</returns>
        protected abstract string Find(WorkloadContext context);

        protected override IEnumerator<Work> Begin()
        {
            using (var reader = PointReaders.Open(m_path))
            using (var preview = new PreviewCloud(reader, new PreviewOptions { Points = SourceFeed.PreviewPoints }))
                yield return Work.Of(preview.Run(null));
        }
    }

    /// <summary>A LAS file.</summary>
    public sealed class BesidePreviewLasWorkload : BesidePreviewWorkload
    {
        public override string Name => "frame beside preview las";

        protected override string Find(WorkloadContext context) => TerrainBenchmarkFile.Make(context);
    }

    /// <summary>A LAZ file, which is decoded whole.</summary>
    public sealed class BesidePreviewLazWorkload : BesidePreviewWorkload
    {
        public override string Name => "frame beside preview laz";

        protected override string Find(WorkloadContext context) => BenchmarkSamples.Find(context, BenchmarkSamples.LazLayered);
    }
}
