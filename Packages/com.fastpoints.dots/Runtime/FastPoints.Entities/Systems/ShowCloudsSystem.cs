using FastPoints.Picture;
using FastPoints.Rendering;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>Tells what draws how clouds are coloured, and what points look like.</summary>
    [WorldSystemFilter(WorldSystemFilterFlags.Default | WorldSystemFilterFlags.Editor)]
    [UpdateInGroup(typeof(PointCloudSystemGroup))]
    [UpdateBefore(typeof(ReceiveNodesSystem))]
    public partial class ShowCloudsSystem : StreamSystem
    {
        EntityQuery m_shown;
        EntityQuery m_styles;

        /// <summary>Of the palette; RGB needs none.</summary>
        ColorMode m_mode = ColorMode.Rgb;
        Gradient m_gradient;

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
            if (!m_styles.IsEmpty)
                UseStyle(scene);
            using (var entities = m_shown.ToEntityArray(Allocator.Temp))
            using (var clouds = m_shown.ToComponentDataArray<StreamedPointCloud>(Allocator.Temp))
            using (var looks = m_shown.ToComponentDataArray<PointCloudLook>(Allocator.Temp))
            {
                // There is one palette: the first cloud that is looked up in one has it.
                int first = -1;
                for (int i = 0; i < clouds.Length; i++)
                {
                    scene.SetLook(clouds[i].Number, looks[i].Value);
                    ShowOthers(scene, entities[i], clouds[i]);
                    first = first < 0 && looks[i].Mode != ColorMode.Rgb ? i : first;
                }
                if (first >= 0)
                    UsePalette(scene, looks[first].Mode, looks[first].Gradient);
            }
        }

        /// <summary>States of a cloud that are drawn with it.</summary>
        void ShowOthers(PointScene scene, Entity entity, StreamedPointCloud cloud)
        {
            if (cloud.Beside == CloudSuccession.None && cloud.Next == CloudSuccession.None ||
                !EntityManager.HasComponent<PointCloudStates>(entity))
                return;
            var looks = EntityManager.GetComponentObject<PointCloudStates>(entity).Looks;
            if (looks.TryGetValue(cloud.Beside, out var beside))
                scene.SetLook(cloud.Beside, beside.Value);
            if (looks.TryGetValue(cloud.Next, out var next))
                scene.SetLook(cloud.Next, next.Value);
        }

        void UseStyle(PointScene scene)
        {
            using (var styles = m_styles.ToComponentDataArray<PointCloudStyle>(Allocator.Temp))
                scene.Style = styles[0].Value;
        }

        void UsePalette(PointScene scene, ColorMode mode, Gradient gradient)
        {
            if ((mode, gradient) == (m_mode, m_gradient))
                return;
            (m_mode, m_gradient) = (mode, gradient);
            using (var palette = Palettes.Create(mode, Allocator.Temp, gradient))
                scene.SetPalette(palette);
        }
    }
}
