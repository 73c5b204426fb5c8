using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>The layer of a cloud: cameras draw it whose culling mask has the layer. A cloud without it is drawn by
    /// all.</summary>
    public struct PointCloudLayer : IComponentData
    {
        /// <summary>0 to 31, as that of a GameObject.</summary>
        public int Value;

        internal ulong Scenes;

        internal bool IsHiddenInSceneViews;

        internal readonly bool IsSame(in PointCloudLayer other) => Value == other.Value && Scenes == other.Scenes &&
            IsHiddenInSceneViews == other.IsHiddenInSceneViews;
    }
}
