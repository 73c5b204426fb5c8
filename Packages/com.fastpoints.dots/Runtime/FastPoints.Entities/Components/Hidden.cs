using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>Users enable this: the node is not drawn, though what is below it is.</summary>
    public struct Hidden : IComponentData, IEnableableComponent
    {
    }
}
