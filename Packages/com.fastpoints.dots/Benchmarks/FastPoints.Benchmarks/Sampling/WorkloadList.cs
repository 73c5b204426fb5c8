using System;
using System.Collections.Generic;
using System.Linq;

namespace FastPoints.Benchmarks
{
    /// <summary>Every workload of this assembly: what implements <see cref="IWorkload"/> is in it.</summary>
    public static class WorkloadList
    {
        public static List<IWorkload> All() =>
            typeof(IWorkload).Assembly.GetTypes()
                .Where(t => !t.IsAbstract && !t.IsInterface && typeof(IWorkload).IsAssignableFrom(t))
                .Select(t => (IWorkload)Activator.CreateInstance(t))
                .OrderBy(w => w.Name, StringComparer.Ordinal)
                .ToList();
    }
}
