using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>Users enable this: the node is not given up while the memory budget has room for it at all.</summary>
    public struct Pinned : IComponentData, IEnableableComponent
    {
    }
}
