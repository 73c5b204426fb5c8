namespace Unity.Jobs;

public interface IJobFor
{
    void Execute(int index);
}

public static unsafe class IJobForExtensions
{
    struct Kind<T> : IJobKind<T> where T : struct, IJobFor
    {
        public void Execute(ref T job, int begin, int end)
        {
            for (int i = begin; i < end; i++)
                job.Execute(i);
        }
    }

    public static JobHandle Schedule<T>(this T jobData, int arrayLength, JobHandle dependency) where T : struct, IJobFor =>
        JobScheduler.Schedule<T, Kind<T>>(ref jobData, arrayLength, arrayLength, false, dependency);

    public static JobHandle ScheduleParallel<T>(this T jobData, int arrayLength, int innerloopBatchCount,
        JobHandle dependency) where T : struct, IJobFor =>
        JobScheduler.Schedule<T, Kind<T>>(ref jobData, arrayLength, innerloopBatchCount, true, dependency);

    public static void Run<T>(this T jobData, int arrayLength) where T : struct, IJobFor =>
        JobScheduler.Run<T, Kind<T>>(ref jobData, arrayLength, false);
}
