using StandIns.Scheduling;
using Unity.Collections;

namespace Unity.Jobs
{
    /// <summary>A parallel job whose length is known only when the jobs before it are done.</summary>
    public interface IJobParallelForDefer
    {
        void Execute(int index);
    }

    public static unsafe class IJobParallelForDeferExtensions
    {
        struct Kind<T> : IJobKind<T> where T : struct, IJobParallelForDefer
        {
            public void Execute(ref T job, int begin, int end, int batchSize)
            {
                for (int i = begin; i < end; i++)
                    job.Execute(i);
            }
        }

        public static void EarlyJobInit<T>() where T : struct, IJobParallelForDefer
        {
        }

        public static JobHandle Schedule<T, U>(this T jobData, NativeList<U> list, int innerloopBatchCount,
            JobHandle dependsOn = default) where T : struct, IJobParallelForDefer where U : unmanaged =>
            Schedule(ref jobData, &list.m_ListData->m_length, innerloopBatchCount, dependsOn);

        public static JobHandle ScheduleByRef<T, U>(this ref T jobData, NativeList<U> list, int innerloopBatchCount,
            JobHandle dependsOn = default) where T : struct, IJobParallelForDefer where U : unmanaged =>
            Schedule(ref jobData, &list.m_ListData->m_length, innerloopBatchCount, dependsOn);

        public static JobHandle Schedule<T>(this T jobData, int* forEachCount, int innerloopBatchCount,
            JobHandle dependsOn = default) where T : struct, IJobParallelForDefer =>
            Schedule(ref jobData, forEachCount, innerloopBatchCount, dependsOn);

        public static JobHandle ScheduleByRef<T>(this ref T jobData, int* forEachCount, int innerloopBatchCount,
            JobHandle dependsOn = default) where T : struct, IJobParallelForDefer =>
            Schedule(ref jobData, forEachCount, innerloopBatchCount, dependsOn);

        static JobHandle Schedule<T>(ref T jobData, int* length, int innerloopBatchCount, JobHandle dependsOn)
            where T : struct, IJobParallelForDefer =>
            JobScheduler.Schedule<T, Kind<T>>(ref jobData, 0, innerloopBatchCount, true, dependsOn, length);
    }
}
