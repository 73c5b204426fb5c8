using Unity.Collections;
using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>The world's <see cref="PointCloudBudget"/>, where there is one, holds from this frame on.</summary>
    [WorldSystemFilter(WorldSystemFilterFlags.Default | WorldSystemFilterFlags.Editor)]
    [UpdateInGroup(typeof(PointCloudSystemGroup), OrderFirst = true)]
    [UpdateBefore(typeof(OpenCloudsSystem))]
    public partial class ApplyBudgetSystem : StreamSystem
    {
        EntityQuery m_budgets;

        protected override void OnCreate()
        {
            base.OnCreate();
            m_budgets = GetEntityQuery(ComponentType.ReadOnly<PointCloudBudget>());
        }

        protected override void OnUpdate()
        {
            if (m_budgets.IsEmpty)
                return;
            using (var budgets = m_budgets.ToComponentDataArray<PointCloudBudget>(Allocator.Temp))
            {
                var settings = Group.Stream.Settings;
                settings.Selection.PointBudget = budgets[0].Points;
                settings.Selection.SmallestNodePx = budgets[0].SmallestNodePx;
                settings.UploadBytesPerFrame = budgets[0].UploadBytesPerFrame;
                Group.Stream.Pool.LimitBytes = budgets[0].PoolBytes;
            }
        }
    }
}
