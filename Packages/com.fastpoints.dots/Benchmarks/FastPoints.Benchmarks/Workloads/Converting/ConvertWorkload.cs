using System.Collections.Generic;
using System.IO;
using FastPoints.Build;
using FastPoints.Nodes;
using FastPoints.Sources;

namespace FastPoints.Benchmarks
{
    sealed class ConvertWorkload : IWorkload
    {
        readonly Sampler m_sampler;
        string m_source, m_target;

        ConvertWorkload(string name, Sampler sampler) => (Name, m_sampler) = (name, sampler);

        public static IEnumerable<IWorkload> All() => new[]
        {
            new ConvertWorkload("convert random", Sampler.Random), new ConvertWorkload("convert poisson", Sampler.Poisson),
        };

        public string Name { get; }
        public string LimitName => "convert bare pass";

        public void Prepare(WorkloadContext context)
        {
            m_source = TerrainBenchmarkFile.Make(context);
            m_target = Path.Combine(context.ScratchFolder, Name + ".fastpoints");
            Run();
        }

        public WorkloadResult Run()
        {
            ConvertResult result = null;
            var settings = new ConvertSettings
            {
                Sampler = m_sampler,
                Attributes = new[] { AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue },
            };
            using var reader = PointReaders.Open(m_source);
            JobCoroutine.RunToEnd(ConvertCloud.Run(new[] { reader }, m_target, settings, r => result = r, null));
            return new WorkloadResult { Points = result.Manifest.Points, Bytes = reader.Info.FileBytes };
        }

        public void Dispose()
        {
            if (Directory.Exists(m_target))
                Directory.Delete(m_target, true);
        }
    }
}
