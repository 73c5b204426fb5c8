namespace Unity.Jobs;

public interface IJob
{
    void Execute();
}

public static unsafe class IJobExtensions
{
    struct Kind<T> : IJobKind<T> where T : struct, IJob
    {
        public void Execute(ref T job, int begin, int end) => job.Execute();
    }

    public static JobHandle Schedule<T>(this T jobData, JobHandle dependsOn = default) where T : struct, IJob =>
        JobScheduler.Schedule<T, Kind<T>>(ref jobData, 1, 1, false, dependsOn);

    public static JobHandle ScheduleByRef<T>(this ref T jobData, JobHandle dependsOn = default) where T : struct, IJob =>
        JobScheduler.Schedule<T, Kind<T>>(ref jobData, 1, 1, false, dependsOn);

    public static void Run<T>(this T jobData) where T : struct, IJob => JobScheduler.Run<T, Kind<T>>(ref jobData, 1, false);

    public static void RunByRef<T>(this ref T jobData) where T : struct, IJob =>
        JobScheduler.Run<T, Kind<T>>(ref jobData, 1, false);
}
