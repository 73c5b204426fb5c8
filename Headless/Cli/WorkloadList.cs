using System;
using System.Collections.Generic;
using System.Linq;
using FastPoints.Benchmarks;

namespace FastPoints.Cli
{
    /// <summary>Every workload of the Benchmarks assembly: a struct that implements <see cref="IWorkload"/> is in it.</summary>
    public static class WorkloadList
    {
        public static List<IWorkload> All() =>
            typeof(IWorkload).Assembly.GetTypes()
                .Where(t => t is { IsAbstract: false, IsInterface: false } && typeof(IWorkload).IsAssignableFrom(t))
                .Select(t => (IWorkload)Activator.CreateInstance(t)!)
                .OrderBy(w => w.Name, StringComparer.Ordinal)
                .ToList();
    }
}
