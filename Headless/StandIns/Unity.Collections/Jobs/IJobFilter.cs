using StandIns.Scheduling;
using Unity.Collections;

namespace Unity.Jobs
{
    /// <summary>Keeps, or appends, the indices for which Execute says true.</summary>
    public interface IJobFilter
    {
        bool Execute(int index);
    }

    public static unsafe class IJobFilterExtensions
    {
        struct Wrapper<T> where T : struct, IJobFilter
        {
            public T Job;
            public NativeList<int> Indices;
            // -1: filter the list itself.
            public int AppendCount;
        }

        struct Kind<T> : IJobKind<Wrapper<T>> where T : struct, IJobFilter
        {
            public void Execute(ref Wrapper<T> wrapper, int begin, int end, int batchSize)
            {
                if (wrapper.AppendCount >= 0)
                {
                    for (int i = 0; i < wrapper.AppendCount; i++)
                        if (wrapper.Job.Execute(i))
                            wrapper.Indices.Add(i);
                    return;
                }
                int kept = 0;
                for (int i = 0; i < wrapper.Indices.Length; i++)
                {
                    int index = wrapper.Indices[i];
                    if (wrapper.Job.Execute(index))
                        wrapper.Indices[kept++] = index;
                }
                wrapper.Indices.ResizeUninitialized(kept);
            }
        }

        public static void EarlyJobInit<T>() where T : struct, IJobFilter
        {
        }

        public static JobHandle ScheduleAppend<T>(this T jobData, NativeList<int> indices, int arrayLength,
            JobHandle dependsOn = default) where T : struct, IJobFilter =>
            Schedule(ref jobData, indices, arrayLength, dependsOn);

        public static JobHandle ScheduleAppendByRef<T>(this ref T jobData, NativeList<int> indices, int arrayLength,
            JobHandle dependsOn = default) where T : struct, IJobFilter =>
            Schedule(ref jobData, indices, arrayLength, dependsOn);

        public static JobHandle ScheduleFilter<T>(this T jobData, NativeList<int> indices, JobHandle dependsOn = default)
            where T : struct, IJobFilter => Schedule(ref jobData, indices, -1, dependsOn);

        public static JobHandle ScheduleFilterByRef<T>(this ref T jobData, NativeList<int> indices,
            JobHandle dependsOn = default) where T : struct, IJobFilter => Schedule(ref jobData, indices, -1, dependsOn);

        public static void RunAppend<T>(this T jobData, NativeList<int> indices, int arrayLength)
            where T : struct, IJobFilter => Run(ref jobData, indices, arrayLength);

        public static void RunAppendByRef<T>(this ref T jobData, NativeList<int> indices, int arrayLength)
            where T : struct, IJobFilter => Run(ref jobData, indices, arrayLength);

        public static void RunFilter<T>(this T jobData, NativeList<int> indices) where T : struct, IJobFilter =>
            Run(ref jobData, indices, -1);

        public static void RunFilterByRef<T>(this ref T jobData, NativeList<int> indices) where T : struct, IJobFilter =>
            Run(ref jobData, indices, -1);

        static JobHandle Schedule<T>(ref T jobData, NativeList<int> indices, int appendCount, JobHandle dependsOn)
            where T : struct, IJobFilter
        {
            var wrapper = new Wrapper<T> { Job = jobData, Indices = indices, AppendCount = appendCount };
            return JobScheduler.Schedule<Wrapper<T>, Kind<T>>(ref wrapper, 1, 1, false, dependsOn);
        }

        static void Run<T>(ref T jobData, NativeList<int> indices, int appendCount) where T : struct, IJobFilter
        {
            var wrapper = new Wrapper<T> { Job = jobData, Indices = indices, AppendCount = appendCount };
            JobScheduler.Run<Wrapper<T>, Kind<T>>(ref wrapper, 1, false);
        }
    }
}
