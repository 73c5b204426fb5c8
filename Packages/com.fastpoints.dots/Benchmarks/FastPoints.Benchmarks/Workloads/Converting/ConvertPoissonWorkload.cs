using System.IO;
using FastPoints.Base;
using FastPoints.Convert;
using FastPoints.Files;
using FastPoints.Points;
using FastPoints.Samplers;

namespace FastPoints.Benchmarks
{
    /// <summary>The whole conversion, position and colour, with the Poisson sampler.</summary>
    public struct ConvertPoissonWorkload : IWorkload
    {
        string m_source;
        string m_target;

        public string Name => "convert poisson";
        public string LimitName => "convert bare pass";

        public void Prepare(WorkloadContext context)
        {
            m_source = TerrainBenchmarkFile.Make(context);
            m_target = Path.Combine(context.ScratchFolder, "poisson.fastpoints");
            Run();
        }

        public WorkloadResult Run()
        {
            ConvertResult result = null;
            var settings = new ConvertSettings
            {
                Sampler = Sampler.Poisson,
                Attributes = new[] { AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue },
            };
            using (var reader = PointReaders.Open(m_source))
            {
                WorkPump.RunToEnd(ConvertCloud.Run(new[] { reader }, m_target, settings, r => result = r, null));
                return new WorkloadResult { Points = result.Manifest.Points, Bytes = reader.Info.FileBytes };
            }
        }

        public void Dispose()
        {
            if (Directory.Exists(m_target))
                Directory.Delete(m_target, true);
        }
    }
}
