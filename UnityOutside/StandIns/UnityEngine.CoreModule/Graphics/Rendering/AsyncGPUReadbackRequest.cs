namespace UnityEngine.Rendering;

/// <summary>What was asked for, and the data when it is there: until the end of the frame that it came in.</summary>
public struct AsyncGPUReadbackRequest
{
    int m_id;

    internal AsyncGPUReadbackRequest(int id) => m_id = id;

    /// <summary>Looked up each time; a request whose data is gone is done, with an error.</summary>
    public bool done => ReadbackTable.Find(m_id)?.IsDone ?? true;

    public bool hasError => ReadbackTable.Find(m_id) == null;

    public void WaitForCompletion() => ReadbackTable.Find(m_id)?.Wait();

    /// <exception cref="System.InvalidOperationException">Not done, or the data is gone.</exception>
    public NativeArray<T> GetData<T>(int layer = 0) where T : struct => ReadbackTable.Data<T>(m_id, layer);
}
