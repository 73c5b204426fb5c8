using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Entities;
using Unity.Mathematics;

namespace Unity.Physics;

/// <summary>As in the package, a header: what it is made of follows in memory.</summary>
public unsafe struct Collider
{
    internal int Vertices;
    internal int Triangles;
    internal CollisionFilter Filter;
}

public struct CollisionFilter : IEquatable<CollisionFilter>
{
    public uint BelongsTo;
    public uint CollidesWith;
    public int GroupIndex;

    public static readonly CollisionFilter Default = new() { BelongsTo = 0xffffffff, CollidesWith = 0xffffffff };

    public readonly bool Equals(CollisionFilter other) =>
        (BelongsTo, CollidesWith, GroupIndex) == (other.BelongsTo, other.CollidesWith, other.GroupIndex);
}

public unsafe struct MeshCollider
{
    public static BlobAssetReference<Collider> Create(NativeArray<float3> vertices, NativeArray<int3> triangles,
        CollisionFilter filter)
    {
        using var kept = new NativeList<int3>(triangles.Length, Allocator.Temp);
        foreach (int3 triangle in triangles)
            if (math.any(triangle < 0) || math.any(triangle >= vertices.Length))
                throw new ArgumentException("Triangle indices out of range.", nameof(triangles));
            else if (math.lengthsq(math.cross(vertices[triangle.y] - vertices[triangle.x],
                vertices[triangle.z] - vertices[triangle.x])) >= 1e-7f)
                kept.Add(triangle);
        var head = new Collider { Vertices = vertices.Length, Triangles = kept.Length, Filter = filter };
        using var bytes = new NativeArray<byte>(sizeof(Collider) + 12 * (head.Vertices + head.Triangles), Allocator.Temp);
        byte* at = (byte*)bytes.GetUnsafePtr();
        *(Collider*)at = head;
        UnsafeUtility.MemCpy(at + sizeof(Collider), vertices.GetUnsafeReadOnlyPtr(), 12L * head.Vertices);
        UnsafeUtility.MemCpy(at + sizeof(Collider) + 12 * head.Vertices, kept.GetUnsafePtr(), 12L * head.Triangles);
        return BlobAssetReference<Collider>.Create(at, bytes.Length);
    }
}

public struct PhysicsCollider : IComponentData
{
    public BlobAssetReference<Collider> Value;
}

public struct PhysicsWorldIndex : ISharedComponentData { }
