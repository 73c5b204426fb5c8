using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>The node is in the list of what to draw.</summary>
    public struct Drawn : IComponentData, IEnableableComponent
    {
    }
}
