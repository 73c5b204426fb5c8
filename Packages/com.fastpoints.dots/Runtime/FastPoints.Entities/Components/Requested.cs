using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>The node is on its way: not all of it is in memory.</summary>
    public struct Requested : IComponentData, IEnableableComponent
    {
    }
}
