using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Runtime.CompilerServices;
using Unity.Entities;
using Unity.Jobs.LowLevel.Unsafe;

[assembly: InternalsVisibleTo("HostTests")]
[assembly: InternalsVisibleTo("FastPoints.Tests")]
[assembly: InternalsVisibleTo("Unity.Entities.Hybrid")]

namespace RealEntities
{
    /// <summary>What Unity does once scripts are loaded: it calls what its post-processors have put into assemblies. For those
    /// that were not processed their jobs are registered by reflection.</summary>
    public static class Loading
    {
        const BindingFlags Any = BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic;

        static bool s_isDone;
        public static HashSet<string> Processed { get; } = new HashSet<string>();

        public static void Once()
        {
            if (s_isDone)
                return;
            s_isDone = true;
            Assembly[] assemblies = Directory.GetFiles(AppContext.BaseDirectory, "*.dll").Select(Path.GetFileNameWithoutExtension)
                .Where(n => n.StartsWith("FastPoints") || n.StartsWith("Unity.") || n == "HostTests").Select(Assembly.Load)
                .ToArray();
            foreach (Assembly assembly in assemblies)
                CallGenerated(assembly);
            foreach (Assembly assembly in assemblies.Where(a => !Processed.Contains(a.GetName().Name)))
                RegisterJobs(assembly);
        }

        static void CallGenerated(Assembly assembly)
        {
            IEnumerable<MethodInfo> generated = assembly.GetTypes()
                .Where(t => t.Name.StartsWith("__") && t.Name.Contains("Output"))
                .SelectMany(t => t.GetMethods(Any))
                .Where(m => m.IsDefined(typeof(UnityEngine.RuntimeInitializeOnLoadMethodAttribute)));
            foreach (MethodInfo method in generated)
            {
                method.Invoke(null, null);
                Processed.Add(assembly.GetName().Name);
            }
        }

        static void RegisterJobs(Assembly assembly)
        {
            IEnumerable<Type> generic = assembly.GetCustomAttributes<Unity.Jobs.RegisterGenericJobTypeAttribute>()
                .Select(a => a.ConcreteType);
            foreach (Type job in assembly.GetTypes().Where(t => t.IsValueType && !t.ContainsGenericParameters).Concat(generic))
                foreach (Type kind in job.GetInterfaces())
                    InitializerOf(kind)?.MakeGenericMethod(job).Invoke(null, null);
        }

        static MethodInfo InitializerOf(Type kindOfJob) =>
            kindOfJob.GetCustomAttribute<JobProducerTypeAttribute>()?.ProducerType.DeclaringType?.GetMethods(Any)
                .FirstOrDefault(m => m.Name == "EarlyJobInit" && m.GetGenericArguments().Length == 1);
    }
}

namespace StandIns.Entities
{
    static class SystemOrder
    {
        internal static bool IsBackwards { get; set; } // No meaning here: what no attribute orders is by Unity's hash.
    }
}
