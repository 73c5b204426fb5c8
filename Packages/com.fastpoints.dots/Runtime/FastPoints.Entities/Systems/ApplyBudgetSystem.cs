using Unity.Collections;
using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>Applies the world's <see cref="PointCloudBudget"/> from this frame on. Without one, it applies
    /// <see cref="PointCloudSystemGroup.DefaultPoolBytes"/> to memory that the world itself has made.</summary>
    [WorldSystemFilter(WorldSystemFilterFlags.Default | WorldSystemFilterFlags.Editor)]
    [UpdateInGroup(typeof(PointCloudSystemGroup), OrderFirst = true)]
    [UpdateBefore(typeof(OpenCloudsSystem))]
    internal partial class ApplyBudgetSystem : StreamSystem
    {
        EntityQuery m_budgets;

        /// <summary>The default in force; 0 while there is a budget.</summary>
        long m_defaultPoolBytes;

        protected override void OnCreate()
        {
            base.OnCreate();
            m_budgets = GetEntityQuery(ComponentType.ReadOnly<PointCloudBudget>());
        }

        protected override void OnUpdate()
        {
            if (m_budgets.IsEmpty)
            {
                ApplyDefault();
                return;
            }
            m_defaultPoolBytes = 0;
            using var budgets = m_budgets.ToComponentDataArray<PointCloudBudget>(Allocator.Temp);
            var settings = Group.Stream.Settings;
            settings.Selection.PointBudget = budgets[0].Points;
            settings.Selection.SmallestNodePx = budgets[0].SmallestNodePx;
            settings.UploadBytesPerFrame = budgets[0].UploadBytesPerFrame;
            Group.Stream.Pool.LimitBytes = budgets[0].PoolBytes;
        }

        void ApplyDefault()
        {
            if (Group.Scene == null || m_defaultPoolBytes == PointCloudSystemGroup.DefaultPoolBytes)
                return;
            m_defaultPoolBytes = PointCloudSystemGroup.DefaultPoolBytes;
            Group.Stream.Pool.LimitBytes = m_defaultPoolBytes;
        }
    }
}
