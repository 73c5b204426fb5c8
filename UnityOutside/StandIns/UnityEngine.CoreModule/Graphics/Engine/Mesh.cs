namespace UnityEngine;

/// <summary>Triangles in memory, which nothing draws here.</summary>
public sealed class Mesh : Object
{
    static readonly Dictionary<int, Mesh> s_all = new Dictionary<int, Mesh>();
    IndexFormat m_format;

    public Mesh()
    {
        lock (s_all)
            s_all.Add(Id, this);
    }

    internal Vector3[] Vertices { get; private set; } = [];
    internal uint[] Indices { get; private set; } = [];

    internal bool IsBaked { get; set; } // Whether what it has now was prepared for physics.

    internal static int Count
    {
        get
        {
            lock (s_all)
                return s_all.Count;
        }
    }

    internal static Mesh Find(int id)
    {
        lock (s_all)
            return s_all.TryGetValue(id, out var mesh) ? mesh : null;
    }

    public IndexFormat indexFormat
    {
        get => There(m_format);
        set
        {
            CheckIsThere();
            m_format = value;
        }
    }

    /// <summary>Unity does not say whether the format stays: here it does not.</summary>
    public void Clear()
    {
        CheckIsThere();
        (Vertices, Indices, IsBaked, m_format) = ([], [], false, IndexFormat.UInt16);
    }

    public void SetVertices<T>(NativeArray<T> inVertices) where T : struct
    {
        CheckIsThere();
        if (SystemUnsafe.SizeOf<T>() != 12)
            throw new ArgumentException("SetVertices with NativeArray should use struct type that is 12 bytes (3x float) in "
                + "size");
        Vertices = inVertices.Reinterpret<Vector3>(SystemUnsafe.SizeOf<T>()).ToArray();
        IsBaked = false;
    }

    /// <summary>Of four bytes each.</summary>
    public void SetIndices<T>(NativeArray<T> indices, MeshTopology topology, int submesh, bool calculateBounds = true,
        int baseVertex = 0) where T : struct
    {
        CheckIsThere();
        var numbers = indices.Reinterpret<uint>(SystemUnsafe.SizeOf<T>()).ToArray();
        if (topology != MeshTopology.Triangles || submesh != 0 || !calculateBounds || baseVertex != 0)
            throw new NotSupportedException("wanted triangles of the first part, with bounds");
        if (m_format == IndexFormat.UInt16 && Vertices.Length > ushort.MaxValue)
            throw new ArgumentException("The number of vertices is too high for indices of 16 bits.");
        if (numbers.Length % 3 != 0 || Array.Exists(numbers, n => n >= Vertices.Length))
            throw new ArgumentException("Failed setting triangles. Some indices are referencing out of bounds vertices.");
        (Indices, IsBaked) = (numbers, false);
    }

    internal override void OnDestroyed()
    {
        lock (s_all)
            s_all.Remove(Id);
    }
}
