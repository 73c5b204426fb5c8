using FastPoints.Entities;
using Unity.Collections;
using Unity.Entities;
using Unity.Mathematics;

namespace FastPoints.Samples.EntitiesOnly
{
    /// <summary>Tints each node by its size, so that the octree's levels can be told apart. A node's entity exists as long as the
    /// node is in memory: new ones are those without a tint.</summary>
    [DisableAutoCreation]
    public partial class TintNodesSystem : SystemBase
    {
        /// <summary>sRGB colours with red in the lowest byte: one for each halving of a node's size.</summary>
        static readonly uint[] s_tints = { 0xFF8080FF, 0xFF80C0FF, 0xFF80FFFF, 0xFF80FF80, 0xFFFFC080, 0xFFFF8080, 0xFFFF80FF };

        EntityQuery m_untinted;

        protected override void OnCreate() => m_untinted = new EntityQueryBuilder(Allocator.Temp)
            .WithAll<PointCloudNode>().WithAll<PointCloudNodeBounds>().WithDisabled<Tint>().Build(this);

        protected override void OnUpdate()
        {
            if (m_untinted.IsEmpty)
                return;
            using var nodes = m_untinted.ToEntityArray(Allocator.Temp);
            using var bounds = m_untinted.ToComponentDataArray<PointCloudNodeBounds>(Allocator.Temp);
            for (int i = 0; i < nodes.Length; i++)
            {
                EntityManager.SetComponentData(nodes[i], new Tint { Rgba = s_tints[Step(bounds[i].Half)] });
                EntityManager.SetComponentEnabled<Tint>(nodes[i], true);
            }
        }

        static int Step(float3 half)
        {
            int halvings = (int)math.round(math.log2(math.max(math.cmax(half), 1e-6f)));
            return ((halvings % s_tints.Length) + s_tints.Length) % s_tints.Length;
        }
    }
}
