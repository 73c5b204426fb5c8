using FastPoints.Gpu;
using FastPoints.Picture;
using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>How a cloud is coloured, and which classes it shows. Clouds that are opened from files have one as their
    /// <see cref="PointCloudFile"/> says; users may write another, of planes that are streamed.</summary>
    public struct PointCloudLook : IComponentData
    {
        /// <summary>Decides on the palette, with <see cref="Gradient"/>: of clouds that are looked up in one, all should have the
        /// same.</summary>
        public ColorMode Mode;
        public Gradient Gradient;
        public CloudLook Value;
    }
}
