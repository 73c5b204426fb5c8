namespace StandIns.Graphics;

sealed unsafe class ReadbackEntry
{
    internal readonly int Width;
    internal readonly int Height;
    internal readonly int Layers;
    internal readonly int LayerBytes;
    readonly GpuBuffer m_copy;
    readonly Action<AsyncGPUReadbackRequest> m_callback;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
    readonly AtomicSafetyHandle m_safety = AtomicSafetyHandle.Create();
#endif

    internal ReadbackEntry(GpuBuffer copy, int width, int height, int layers, int layerBytes,
        Action<AsyncGPUReadbackRequest> callback)
    {
        m_copy = copy;
        Width = width;
        Height = height;
        Layers = layers;
        LayerBytes = layerBytes;
        m_callback = callback;
    }

    internal int Id { get; set; }
    internal bool IsDone { get; private set; }

    internal void Poll()
    {
        if (!IsDone && GpuDevice.Current.Queue.HasPassed(m_copy.LastUse))
            Finish();
    }

    internal void Wait()
    {
        if (IsDone)
            return;
        GpuDevice.Current.Queue.Await(m_copy.LastUse);
        Finish();
    }

    internal NativeArray<T> Data<T>(int layer) where T : struct
    {
        NativeArray<T> array =
            NativeArrayUnsafeUtility.ConvertExistingDataToNativeArray<T>(m_copy.Mapped + (long)layer * LayerBytes,
            LayerBytes / UnsafeUtility.SizeOf<T>(), Allocator.None);
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        NativeArrayUnsafeUtility.SetAtomicSafetyHandle(ref array, m_safety);
#endif
        return array;
    }

    internal void Dispose()
    {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        AtomicSafetyHandle.CheckDeallocateAndThrow(m_safety);
        AtomicSafetyHandle.Release(m_safety);
#endif
        m_copy.Destroy(GpuDevice.Current);
    }

    void Finish()
    {
        IsDone = true;
        m_callback?.Invoke(new AsyncGPUReadbackRequest(Id));
    }
}
