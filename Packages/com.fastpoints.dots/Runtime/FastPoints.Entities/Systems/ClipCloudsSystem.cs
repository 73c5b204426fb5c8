using FastPoints.Streaming;
using Unity.Collections;
using Unity.Entities;
using Unity.Mathematics;
using Unity.Transforms;

namespace FastPoints.Entities
{
    [WorldSystemFilter(WorldSystemFilterFlags.Default | WorldSystemFilterFlags.Editor)]
    [UpdateInGroup(typeof(PointCloudSystemGroup), OrderFirst = true)]
    [UpdateAfter(typeof(AddCloudsSystem))]
    internal partial class ClipCloudsSystem : StreamSystem
    {
        EntityQuery m_clips;
        bool m_hasClips; // Boxes that did not come from entities are left alone.

        protected override void OnCreate()
        {
            base.OnCreate();
            m_clips = GetEntityQuery(ComponentType.ReadOnly<PointCloudClip>(), ComponentType.ReadOnly<LocalToWorld>());
        }

        protected override void OnUpdate()
        {
            if (m_clips.IsEmpty && !m_hasClips)
                return;
            m_hasClips = !m_clips.IsEmpty;
            var boxes = Group.Stream.ClipBoxes;
            boxes.Clear();
            using var clips = m_clips.ToComponentDataArray<PointCloudClip>(Allocator.Temp);
            using var matrices = m_clips.ToComponentDataArray<LocalToWorld>(Allocator.Temp);
            for (int i = 0; i < clips.Length; i++)
                boxes.Add(BoxOf(matrices[i].Value, clips[i].Cuts));
        }

        static ClipBox BoxOf(float4x4 matrix, bool cuts) => new ClipBox
        {
            CenterWorld = new double3(matrix.c3.xyz),
            EdgesWorld = new double3x3(new double3(matrix.c0.xyz), new double3(matrix.c1.xyz), new double3(matrix.c2.xyz)),
            Cuts = cuts,
        };
    }
}
