namespace Unity.Jobs;

public interface IJobParallelFor
{
    void Execute(int index);
}

public static unsafe partial class IJobParallelForExtensions
{
    struct Kind<T> : IJobKind<T> where T : struct, IJobParallelFor
    {
        public void Execute(ref T job, int begin, int end)
        {
            for (int i = begin; i < end; i++)
                job.Execute(i);
        }
    }

    public static JobHandle Schedule<T>(this T jobData, int arrayLength, int innerloopBatchCount,
        JobHandle dependsOn = default) where T : struct, IJobParallelFor =>
        JobScheduler.Schedule<T, Kind<T>>(ref jobData, arrayLength, innerloopBatchCount, true, dependsOn);
}
