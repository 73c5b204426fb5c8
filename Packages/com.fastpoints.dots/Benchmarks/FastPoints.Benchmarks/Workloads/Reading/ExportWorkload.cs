using System;
using System.IO;
using FastPoints.Export;
using FastPoints.Sources;

namespace FastPoints.Benchmarks
{
    sealed class ExportWorkload : IWorkload
    {
        readonly Func<WorkloadContext, string> m_find;
        readonly string m_ending;
        string m_path;
        string m_output;

        public ExportWorkload(string name, string limitName, Func<WorkloadContext, string> find, string ending)
        {
            (Name, LimitName) = (name, limitName);
            (m_find, m_ending) = (find, ending);
        }

        public string Name { get; }
        public string LimitName { get; }

        public void Prepare(WorkloadContext context)
        {
            m_path = m_find(context);
            m_output = context.PathOf("export", m_ending);
        }

        public WorkloadResult Run()
        {
            if (m_path == null)
                return default;
            ExportResult result = null;
            using var reader = PointReaders.Open(m_path);
            JobCoroutine.RunToEnd(ExportCloud.Run(reader, m_output, new ExportSettings(), r => result = r, null));
            return new WorkloadResult { Points = result.Points, Bytes = result.Bytes };
        }

        public void Dispose()
        {
            if (m_output != null)
                File.Delete(m_output);
        }
    }
}
