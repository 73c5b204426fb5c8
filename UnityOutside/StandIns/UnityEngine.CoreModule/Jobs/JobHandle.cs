namespace Unity.Jobs
{
    public unsafe struct JobHandle : IEquatable<JobHandle>
    {
        internal int m_Index;
        internal int m_Version;

        internal JobHandle(JobNode node)
        {
            m_Index = node.Index;
            m_Version = node.Version;
        }

        public bool IsCompleted
        {
            get
            {
                JobScheduler.Flush();
                return JobScheduler.IsCompleted(this);
            }
        }

        public void Complete()
        {
            if (m_Index == 0)
                return;
            JobChecks.CheckThread("JobHandle.Complete");
            JobScheduler.Complete(this);
        }

        public static void CompleteAll(ref JobHandle job0, ref JobHandle job1)
        {
            job0.Complete();
            job1.Complete();
            job0 = job1 = default;
        }

        public static void CompleteAll(ref JobHandle job0, ref JobHandle job1, ref JobHandle job2)
        {
            job0.Complete();
            job1.Complete();
            job2.Complete();
            job0 = job1 = job2 = default;
        }

        public static void CompleteAll(NativeArray<JobHandle> jobs)
        {
            for (int i = 0; i < jobs.Length; i++)
                jobs[i].Complete();
        }

        public static JobHandle CombineDependencies(JobHandle job0, JobHandle job1)
        {
            JobHandle* jobs = stackalloc JobHandle[] { job0, job1 };
            return LowLevel.Unsafe.JobHandleUnsafeUtility.CombineDependencies(jobs, 2);
        }

        public static JobHandle CombineDependencies(JobHandle job0, JobHandle job1, JobHandle job2)
        {
            JobHandle* jobs = stackalloc JobHandle[] { job0, job1, job2 };
            return LowLevel.Unsafe.JobHandleUnsafeUtility.CombineDependencies(jobs, 3);
        }

        public static JobHandle CombineDependencies(NativeArray<JobHandle> jobs) =>
            LowLevel.Unsafe.JobHandleUnsafeUtility.CombineDependencies((JobHandle*)jobs.GetUnsafeReadOnlyPtr(), jobs.Length);

        public static void ScheduleBatchedJobs() => JobScheduler.Flush();

        public static bool CheckFenceIsDependencyOrDidSyncFence(JobHandle jobHandle, JobHandle dependsOn)
        {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            return JobRecord.Precedes(jobHandle, dependsOn);
#else
            return jobHandle.IsCompleted || jobHandle.Equals(dependsOn);
#endif
        }

        public bool Equals(JobHandle other) => m_Index == other.m_Index && m_Version == other.m_Version;
        public override bool Equals(object obj) => obj is JobHandle other && Equals(other);
        public override int GetHashCode() => (m_Index * 397) ^ m_Version;
        public static bool operator ==(JobHandle a, JobHandle b) => a.Equals(b);
        public static bool operator !=(JobHandle a, JobHandle b) => !a.Equals(b);
    }
}

namespace Unity.Jobs.LowLevel.Unsafe
{
    public static unsafe class JobHandleUnsafeUtility
    {
        public static JobHandle CombineDependencies(JobHandle* jobs, int count)
        {
            JobChecks.CheckThread("JobHandle.CombineDependencies");
            JobHandle only = default;
            int alive = 0;
            for (int i = 0; i < count; i++)
            {
                if (jobs[i].m_Index == 0)
                    continue;
                only = jobs[i];
                alive++;
            }
            return alive <= 1 ? only : JobScheduler.Combine(jobs, count);
        }
    }
}
