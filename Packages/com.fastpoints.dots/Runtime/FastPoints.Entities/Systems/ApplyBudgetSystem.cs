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
        long m_defaultPoolBytes; // The default in force; 0 while there is a budget.
        PointCloudBudget? m_before; // What was in force before there was a budget, and is again after it.

        protected override void OnCreate()
        {
            base.OnCreate();
            m_budgets = GetEntityQuery(ComponentType.ReadOnly<PointCloudBudget>());
        }

        protected override void OnUpdate()
        {
            if (m_budgets.IsEmpty)
            {
                if (m_before.HasValue)
                    Apply(m_before.Value);
                m_before = null;
                ApplyDefault();
                return;
            }
            m_defaultPoolBytes = 0;
            var settings = Group.Stream.Settings;
            m_before ??= new PointCloudBudget
            {
                Points = settings.Selection.PointBudget,
                PoolBytes = Group.Stream.Pool.LimitBytes,
                MaxUploadBytesPerFrame = settings.MaxUploadBytesPerFrame,
                MinNodePx = settings.Selection.MinNodePx,
                FadeSeconds = settings.FadeSeconds,
            };
            using var budgets = m_budgets.ToComponentDataArray<PointCloudBudget>(Allocator.Temp);
            Apply(budgets[0]);
        }

        void Apply(in PointCloudBudget budget)
        {
            var settings = Group.Stream.Settings;
            settings.Selection.PointBudget = budget.Points;
            settings.Selection.MinNodePx = budget.MinNodePx;
            settings.MaxUploadBytesPerFrame = budget.MaxUploadBytesPerFrame;
            settings.FadeSeconds = budget.FadeSeconds;
            Group.Stream.Pool.LimitBytes = budget.PoolBytes;
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
