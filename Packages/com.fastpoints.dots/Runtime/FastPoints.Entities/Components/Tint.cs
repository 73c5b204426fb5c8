using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>Users enable this: the colours of the node's points are multiplied by it.</summary>
    public struct Tint : IComponentData, IEnableableComponent
    {
        /// <summary>sRGB: red, green, blue, alpha from the lowest byte; white leaves colours as they are.</summary>
        public uint Rgba;
    }
}
