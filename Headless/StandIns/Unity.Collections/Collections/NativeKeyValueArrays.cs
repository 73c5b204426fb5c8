using Unity.Jobs;

namespace Unity.Collections
{
    public struct NativeKeyValueArrays<TKey, TValue> : INativeDisposable where TKey : unmanaged where TValue : unmanaged
    {
        public NativeArray<TKey> Keys;
        public NativeArray<TValue> Values;

        public NativeKeyValueArrays(int length, AllocatorManager.AllocatorHandle allocator, NativeArrayOptions options)
        {
            Keys = CollectionHelper.CreateNativeArray<TKey>(length, allocator, options);
            Values = CollectionHelper.CreateNativeArray<TValue>(length, allocator, options);
        }

        public int Length => Keys.Length;

        public void Dispose()
        {
            Keys.Dispose();
            Values.Dispose();
        }

        public JobHandle Dispose(JobHandle inputDeps) => Keys.Dispose(Values.Dispose(inputDeps));
    }
}
