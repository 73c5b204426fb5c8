using FastPoints.Drawing;
using FastPoints.Rendering;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Entities;

namespace FastPoints.Entities
{
    [WorldSystemFilter(WorldSystemFilterFlags.Default | WorldSystemFilterFlags.Editor)]
    [UpdateInGroup(typeof(PointCloudSystemGroup))]
    [UpdateBefore(typeof(ReceiveNodesSystem))]
    internal partial class ShowCloudsSystem : StreamSystem
    {
        EntityQuery m_shown;
        EntityQuery m_styles;
        bool m_hasStyle;

        protected override void OnCreate()
        {
            base.OnCreate();
            m_shown = GetEntityQuery(ComponentType.ReadOnly<StreamedPointCloud>(), ComponentType.ReadOnly<PointCloudLook>());
            m_styles = GetEntityQuery(ComponentType.ReadOnly<PointCloudStyle>());
        }

        protected override void OnUpdate()
        {
            var scene = PointScene.Current;
            if (scene == null || scene.Stream != Group.Stream)
                return;
            UseStyle(scene);
            // The number of a removed cloud may be another's now.
            scene.ClearLooks();
            using var entities = m_shown.ToEntityArray(Allocator.Temp);
            using var clouds = m_shown.ToComponentDataArray<StreamedPointCloud>(Allocator.Temp);
            using var looks = m_shown.ToComponentDataArray<PointCloudLook>(Allocator.Temp);
            for (int i = 0; i < clouds.Length; i++)
            {
                float? light = EntityManager.HasComponent<PointCloudFile>(entities[i])
                    ? EntityManager.GetComponentData<PointCloudFile>(entities[i]).Light : (float?)null;
                scene.SetLook(clouds[i].Number, Lit(looks[i], light));
                ShowOthers(scene, entities[i], clouds[i], light);
            }
        }

        void ShowOthers(PointScene scene, Entity entity, StreamedPointCloud cloud, float? light)
        {
            if (cloud.Preview == CloudVersions.None && cloud.Next == CloudVersions.None)
                return;
            var looks = Group.Live.GetOrAdd(entity).Looks;
            if (looks.TryGetValue(cloud.Preview, out var preview))
                scene.SetLook(cloud.Preview, Lit(preview, light));
            if (looks.TryGetValue(cloud.Next, out var next))
                scene.SetLook(cloud.Next, Lit(next, light));
        }

        static CloudLook Lit(PointCloudLook look, float? light)
        {
            look.Value.Light = light ?? look.Value.Light;
            return look.Value;
        }

        void UseStyle(PointScene scene)
        {
            using var styles = m_styles.ToComponentDataArray<PointCloudStyle>(Allocator.Temp);
            if (styles.Length > 0 || m_hasStyle)
                scene.Style = styles.Length > 0 ? styles[0].Value : PointStyle.Default;
            m_hasStyle = styles.Length > 0;
        }
    }
}
