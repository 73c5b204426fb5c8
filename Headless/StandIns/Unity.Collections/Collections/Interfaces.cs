using System;
using Unity.Jobs;

namespace Unity.Collections
{
    public interface INativeDisposable : IDisposable
    {
        JobHandle Dispose(JobHandle inputDeps);
    }

    public interface IIndexable<T> where T : unmanaged
    {
        int Length { get; set; }

        ref T ElementAt(int index);
    }

    public interface INativeList<T> : IIndexable<T> where T : unmanaged
    {
        int Capacity { get; set; }

        bool IsEmpty { get; }

        T this[int index] { get; set; }

        void Clear();
    }

    [AttributeUsage(AttributeTargets.Constructor | AttributeTargets.Method | AttributeTargets.Class | AttributeTargets.Struct
        | AttributeTargets.Property, AllowMultiple = true)]
    public class GenerateTestsForBurstCompatibilityAttribute : Attribute
    {
        public string RequiredUnityDefine;
        public BurstCompatibleCompileTarget CompileTarget;

        public enum BurstCompatibleCompileTarget
        {
            Player = 0,
            Editor = 1,
            PlayerAndEditor = 2,
        }

        public Type[] GenericTypeArguments { get; set; }
    }
}
