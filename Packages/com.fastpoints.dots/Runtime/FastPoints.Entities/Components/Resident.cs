using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>All of the node is in memory.</summary>
    public struct Resident : IComponentData, IEnableableComponent
    {
    }
}
