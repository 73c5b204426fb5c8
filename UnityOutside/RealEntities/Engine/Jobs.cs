using Unity.Jobs.LowLevel.Unsafe;

namespace StandIns.Scheduling
{
    sealed unsafe class RegisteredJob
    {
        static readonly List<RegisteredJob> s_all = new List<RegisteredJob> { null };
        static readonly Dictionary<(Type, MethodInfo), int> s_ids = new Dictionary<(Type, MethodInfo), int>();
        readonly Delegate m_function; // Kept, so that the function stays where it is.

        RegisteredJob(Type wrapper, Type user, Delegate function)
        {
            m_function = function;
            (User, Layout, Bytes) = (user, JobLayout.Of(wrapper), UnsafeUtility.SizeOf(wrapper));
            RuntimeMethodHandle method = function.Method.MethodHandle;
            Type owner = function.Method.DeclaringType;
            RuntimeHelpers.PrepareMethod(method,
                owner.IsGenericType ? owner.GetGenericArguments().Select(t => t.TypeHandle).ToArray() : null);
            Call = (delegate*<void*, IntPtr, IntPtr, ref JobRanges, int, void>)method.GetFunctionPointer();
        }

        internal Type User { get; }
        internal JobLayout Layout { get; }
        internal int Bytes { get; }
        internal readonly delegate*<void*, IntPtr, IntPtr, ref JobRanges, int, void> Call;

        internal static IntPtr Register(Type wrapper, Type user, object function)
        {
            lock (s_all)
            {
                var key = (wrapper, ((Delegate)function).Method);
                if (!s_ids.TryGetValue(key, out int id))
                {
                    s_ids.Add(key, id = s_all.Count);
                    s_all.Add(new RegisteredJob(wrapper, user, (Delegate)function));
                }
                return (IntPtr)id;
            }
        }

        internal static RegisteredJob Of(IntPtr id)
        {
            lock (s_all)
                return id > 0 && id < s_all.Count ? s_all[(int)id]
                    : throw new InvalidOperationException("Reflection data was not set up by an Initialize() call.");
        }
    }

    sealed unsafe class RegisteredWork : JobWork
    {
        readonly RegisteredJob m_job;
        readonly int m_length;
        readonly void* m_listOfLength;

        /// <param name="listOfLength">Whose length, once the job runs, is the job's; or null.</param>
        internal RegisteredWork(RegisteredJob job, void* data, int length, void* listOfLength)
        {
            (m_job, m_length) = (job, length);
            m_listOfLength = listOfLength;
            Data = (byte*)NativeHeap.Allocate(job.Bytes, 16);
            Buffer.MemoryCopy(data, Data, job.Bytes, job.Bytes);
        }

        internal byte* Data { get; }
        internal override Type JobType => m_job.User;

        internal override void Execute(int begin, int end, bool shared, int threadIndex)
        {
            byte* copy = (byte*)NativeHeap.Allocate(m_job.Bytes, 16);
            try
            {
                Buffer.MemoryCopy(Data, copy, m_job.Bytes, m_job.Bytes);
                foreach (int offset in m_job.Layout.ThreadIndexOffsets)
                    *(int*)(copy + offset) = threadIndex;
                int length = m_length;
                if (m_listOfLength != null)
                    (begin, end) = (0, length = *(int*)((byte*)m_listOfLength + sizeof(void*)));
                if (shared)
                    Restrict(copy, begin, end);
                var ranges = new JobRanges { TotalIterationCount = length, Begin = begin, End = end };
                m_job.Call(copy, default, default, ref ranges, 0);
            }
            finally
            {
                NativeHeap.Free(copy);
            }
        }

        [System.Diagnostics.Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
        void Restrict(byte* job, int begin, int end)
        {
            foreach (JobField field in m_job.Layout.Restricted.Where(f => f.Type.MinIndexOffset >= 0))
            {
                *(int*)(job + field.Offset + field.Type.MinIndexOffset) = begin;
                *(int*)(job + field.Offset + field.Type.MaxIndexOffset) = end - 1;
            }
        }

        internal override void Finish()
        {
            foreach (JobField field in m_job.Layout.Deallocated)
                UnsafeUtility.FreeTracked(*(void**)(Data + field.Offset + field.Type.BufferOffset),
                    *(Allocator*)(Data + field.Offset + field.Type.AllocatorOffset));
            Free();
        }

        internal void Free() => NativeHeap.Free(Data);

        /// <summary>Checks what Unity checks.</summary>
        internal JobRecord Register(bool parallel, JobHandle dependency, bool runsAtOnce)
        {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            try
            {
                JobChecks.CheckThread(runsAtOnce ? "Run" : "Schedule");
                if (m_job.Layout.Refusal != null)
                    throw new InvalidOperationException(m_job.Layout.Refusal);
                return JobChecks.Register(Data, m_job.Layout, m_job.User.Name, parallel, dependency, runsAtOnce);
            }
            catch
            {
                Free();
                throw;
            }
#else
            return null;
#endif
        }
    }

    static unsafe partial class JobScheduler
    {
        internal static JobHandle Schedule(ref JobsUtility.JobScheduleParameters parameters, int length, int batchSize,
            bool parallel, void* listOfLength)
        {
            var job = RegisteredJob.Of(parameters.ReflectionData);
            var work = new RegisteredWork(job, (void*)parameters.JobDataPtr, length, listOfLength);
            if (parameters.ScheduleMode == (int)ScheduleMode.Run)
            {
                Run(work, length);
                return default;
            }
            JobRecord record = work.Register(parallel, parameters.Dependency, false);
            JobNode node = JobNodes.Take();
            node.Work = work;
            node.Record = record;
            node.Shared = parallel && listOfLength == null;
            node.BatchSize = Math.Max(1, batchSize);
            node.Length = length;
            JobHandle handle = Commit(node, parameters.Dependency);
            if (SimulatedWorkers.IsOn)
                SimulatedWorkers.Call();
            else
                JobWorkers.Start();
            Hold(node);
            return handle;
        }

        static void Run(RegisteredWork work, int length)
        {
            JobRecord record = work.Register(false, default, true);
            TempMemory.Mark mark = TempMemory.Now;
            JobThread.Enter();
            try
            {
                work.Execute(0, length, false, JobThread.Index);
            }
            catch (Exception exception)
            {
                UnityEngine.Debug.LogException(exception);
            }
            finally
            {
                JobThread.Leave();
                TempMemory.FreeSince(mark);
                work.Finish();
                record?.Sync();
            }
        }
    }
}

namespace Unity.Jobs
{
    public static unsafe partial class IJobParallelForExtensions
    {
        public static void Run<T>(this T jobData, int arrayLength) where T : struct, IJobParallelFor =>
            JobScheduler.Run<T, Kind<T>>(ref jobData, arrayLength, false);
    }
}

namespace Unity.Jobs.LowLevel.Unsafe
{
    public enum ScheduleMode { Run = 0, Parallel = 1, Single = 2 }

    public struct JobRanges
    {
        public int TotalIterationCount;
        internal int Begin;
        internal int End;
    }

    [AttributeUsage(AttributeTargets.Interface)]
    public sealed class JobProducerTypeAttribute(Type producerType) : Attribute
    {
        public Type ProducerType { get; } = producerType;
    }

    public static unsafe partial class JobsUtility
    {
        static readonly int* s_systemId = (int*)NativeHeap.Allocate(64, 16);

        public struct JobScheduleParameters(void* i_jobData, IntPtr i_reflectionData, JobHandle i_dependency,
            ScheduleMode i_scheduleMode)
        {
            public JobHandle Dependency = i_dependency;
            public int ScheduleMode = (int)i_scheduleMode;
            public IntPtr ReflectionData = i_reflectionData;
            public IntPtr JobDataPtr = (IntPtr)i_jobData;
        }

        public delegate void PanicFunction_();

        internal static PanicFunction_ PanicFunction;

        public static bool IsExecutingJob => JobThread.IsExecuting;
        public static bool JobDebuggerEnabled { get; set; } = true;
        public static bool JobCompilerEnabled { get; set; }

        public static JobHandle Schedule(ref JobScheduleParameters parameters) =>
            JobScheduler.Schedule(ref parameters, 1, 1, false, null);

        public static JobHandle ScheduleParallelFor(ref JobScheduleParameters parameters, int arrayLength,
            int innerloopBatchCount) => JobScheduler.Schedule(ref parameters, arrayLength, innerloopBatchCount,
                parameters.ScheduleMode == (int)ScheduleMode.Parallel, null);

        public static JobHandle ScheduleParallelForDeferArraySize(ref JobScheduleParameters parameters, int innerloopBatchCount,
            void* listData, void* listDataAtomicSafetyHandle) => JobScheduler.Schedule(ref parameters, 1, 1, true, listData);

        public static bool GetWorkStealingRange(ref JobRanges ranges, int jobIndex, out int beginIndex, out int endIndex)
        {
            (beginIndex, endIndex) = (ranges.Begin, ranges.End);
            ranges.Begin = ranges.End;
            return beginIndex < endIndex;
        }

        [System.Diagnostics.Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
        public static void PatchBufferMinMaxRanges(IntPtr bufferRangePatchData, void* jobdata, int startIndex, int rangeSize) { }

        public static IntPtr CreateJobReflectionData(Type type, object managedJobFunction0, object managedJobFunction1 = null,
            object managedJobFunction2 = null) => RegisteredJob.Register(type, type, managedJobFunction0);

        public static IntPtr CreateJobReflectionData(Type wrapperJobType, Type userJobType, object managedJobFunction0) =>
            RegisteredJob.Register(wrapperJobType, userJobType, managedJobFunction0);

        internal static IntPtr GetSystemIdCellPtr() => (IntPtr)s_systemId;
        internal static void ClearSystemIds() { }
        internal static int GetSystemIdMappings(JobHandle* handles, int* systemIds, int maxCount) => 0;
    }
}
