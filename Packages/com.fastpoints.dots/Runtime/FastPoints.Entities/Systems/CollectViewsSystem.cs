using FastPoints.Rendering;
using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>Takes the cameras that were drawn since the last frame, to select for them.</summary>
    [WorldSystemFilter(WorldSystemFilterFlags.Default | WorldSystemFilterFlags.Editor)]
    [UpdateInGroup(typeof(PointCloudSystemGroup), OrderFirst = true)]
    [UpdateBefore(typeof(ApplyBudgetSystem))]
    internal partial class CollectViewsSystem : StreamSystem
    {
        protected override void OnUpdate()
        {
            var scene = PointScene.Current;
            if (scene == null || scene.Stream != Group.Stream)
                return;
            // In edit mode, frames also come between two pictures and after the last one.
            var views = scene.CollectNextViews();
            if (views.Length > 0)
                Group.Views.AddRange(views);
            else
                Group.ReuseViews();
            scene.BeginFrame();
        }
    }
}
