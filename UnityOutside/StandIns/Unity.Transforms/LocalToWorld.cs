using Unity.Entities;
using Unity.Mathematics;

namespace Unity.Transforms;

public struct LocalToWorld : IComponentData
{
    public float4x4 Value;
}
