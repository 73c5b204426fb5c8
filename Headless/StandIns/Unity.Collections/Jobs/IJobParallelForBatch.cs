using System;
using StandIns.Scheduling;

namespace Unity.Jobs
{
    public interface IJobParallelForBatch
    {
        void Execute(int startIndex, int count);
    }

    public static unsafe class IJobParallelForBatchExtensions
    {
        struct Kind<T> : IJobKind<T> where T : struct, IJobParallelForBatch
        {
            public void Execute(ref T job, int begin, int end, int batchSize)
            {
                for (int start = begin; start < end; start += batchSize)
                    job.Execute(start, Math.Min(batchSize, end - start));
            }
        }

        public static void EarlyJobInit<T>() where T : struct, IJobParallelForBatch
        {
        }

        public static JobHandle Schedule<T>(this T jobData, int arrayLength, int indicesPerJobCount,
            JobHandle dependsOn = default) where T : struct, IJobParallelForBatch =>
            ScheduleSingle(ref jobData, arrayLength, indicesPerJobCount, dependsOn);

        public static JobHandle ScheduleByRef<T>(this ref T jobData, int arrayLength, int indicesPerJobCount,
            JobHandle dependsOn = default) where T : struct, IJobParallelForBatch =>
            ScheduleSingle(ref jobData, arrayLength, indicesPerJobCount, dependsOn);

        public static JobHandle ScheduleParallel<T>(this T jobData, int arrayLength, int indicesPerJobCount,
            JobHandle dependsOn = default) where T : struct, IJobParallelForBatch =>
            JobScheduler.Schedule<T, Kind<T>>(ref jobData, arrayLength, indicesPerJobCount, true, dependsOn);

        public static JobHandle ScheduleParallelByRef<T>(this ref T jobData, int arrayLength, int indicesPerJobCount,
            JobHandle dependsOn = default) where T : struct, IJobParallelForBatch =>
            JobScheduler.Schedule<T, Kind<T>>(ref jobData, arrayLength, indicesPerJobCount, true, dependsOn);

        public static JobHandle ScheduleBatch<T>(this T jobData, int arrayLength, int indicesPerJobCount,
            JobHandle dependsOn = default) where T : struct, IJobParallelForBatch =>
            JobScheduler.Schedule<T, Kind<T>>(ref jobData, arrayLength, indicesPerJobCount, true, dependsOn);

        public static JobHandle ScheduleBatchByRef<T>(this ref T jobData, int arrayLength, int indicesPerJobCount,
            JobHandle dependsOn = default) where T : struct, IJobParallelForBatch =>
            JobScheduler.Schedule<T, Kind<T>>(ref jobData, arrayLength, indicesPerJobCount, true, dependsOn);

        public static void Run<T>(this T jobData, int arrayLength, int indicesPerJobCount)
            where T : struct, IJobParallelForBatch =>
            JobScheduler.Run<T, Kind<T>>(ref jobData, arrayLength, false, indicesPerJobCount);

        public static void RunByRef<T>(this ref T jobData, int arrayLength, int indicesPerJobCount)
            where T : struct, IJobParallelForBatch =>
            JobScheduler.Run<T, Kind<T>>(ref jobData, arrayLength, false, indicesPerJobCount);

        public static void RunBatch<T>(this T jobData, int arrayLength) where T : struct, IJobParallelForBatch =>
            JobScheduler.Run<T, Kind<T>>(ref jobData, arrayLength, false, arrayLength);

        public static void RunBatchByRef<T>(this ref T jobData, int arrayLength) where T : struct, IJobParallelForBatch =>
            JobScheduler.Run<T, Kind<T>>(ref jobData, arrayLength, false, arrayLength);

        // One thread runs all batches, one after the other.
        static JobHandle ScheduleSingle<T>(ref T jobData, int arrayLength, int indicesPerJobCount, JobHandle dependsOn)
            where T : struct, IJobParallelForBatch =>
            JobScheduler.Schedule<T, Kind<T>>(ref jobData, arrayLength, indicesPerJobCount, false, dependsOn);
    }
}
