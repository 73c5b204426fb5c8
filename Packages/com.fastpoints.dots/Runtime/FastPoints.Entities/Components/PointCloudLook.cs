using FastPoints.Gpu;
using FastPoints.Picture;
using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>How a cloud is coloured. Clouds that are opened from files have one that suits them; users may write
    /// another, of planes that are streamed.</summary>
    public struct PointCloudLook : IComponentData
    {
        /// <summary>Decides on the palette: of clouds that are looked up in one, all should have the same.</summary>
        public ColorMode Mode;
        public CloudLook Value;
    }
}
