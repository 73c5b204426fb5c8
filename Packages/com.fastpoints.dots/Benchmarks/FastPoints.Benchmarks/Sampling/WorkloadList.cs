using System;
using System.Collections.Generic;
using System.Linq;

namespace FastPoints.Benchmarks
{
    /// <summary>Every workload of this assembly: what implements <see cref="IWorkload"/> and is made of nothing, and the tables
    /// of those that differ by what they are made of.</summary>
    public static class WorkloadList
    {
        public static List<IWorkload> All() => typeof(IWorkload).Assembly.GetTypes()
            .Where(t => typeof(IWorkload).IsAssignableFrom(t) && !t.IsAbstract && HasDefaultConstructor(t))
            .Select(t => (IWorkload)Activator.CreateInstance(t))
            .Concat(ReadingWorkloads.All()).Concat(SelectWorkload.All()).Concat(ConvertWorkload.All())
            .Concat(SceneNodesWorkload.All()).Concat(NormalsWorkload.All()).Concat(QueryWorkload.All())
            .Concat(StreamEditWorkload.All())
            .Concat(ScenePreviewWorkload.All()).Concat(StreamSourceWorkload.All()).Concat(BesideFramesWorkload.All())
            .OrderBy(w => w.Name, StringComparer.Ordinal).ToList();

        static bool HasDefaultConstructor(Type type) => type.IsValueType || type.GetConstructor(Type.EmptyTypes) != null;
    }
}
