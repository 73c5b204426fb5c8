using FastPoints.Streaming;
using Unity.Entities;
using Unity.Mathematics;
using UnityEngine;

namespace FastPoints.Entities
{
    /// <summary>Computes boxes around clouds as the engine keeps them, in float: for display, not for measuring.</summary>
    static class CloudBounds
    {
        public static unsafe bool TryGet(EntityManager entities, Entity entity, out Bounds local)
        {
            local = default;
            if (!entities.HasComponent<PointCloudSpace>(entity) || !entities.HasComponent<StreamedPointCloud>(entity))
                return false;
            int number = entities.GetComponentData<StreamedPointCloud>(entity).Number;
            var cloud = entities.World.GetExistingSystemManaged<PointCloudSystemGroup>()?.Stream?.Clouds[number];
            if (cloud == null || !cloud.Pages[0].IsLoaded || cloud.Pages[0].NodeCount == 0)
                return false;
            var corner = cloud.Source.Grid.ToGeo(cloud.Source.Root.Corner);
            var root = cloud.Pages[0].Nodes[0];
            local = Of(new BoundsGeo(corner + root.Center - root.Half, corner + root.Center + root.Half),
                entities.GetComponentData<PointCloudSpace>(entity).Value);
            return true;
        }

        public static bool TryGet(PointCloudAsset asset, out Bounds local)
        {
            local = default;
            if (asset == null || !asset.TryGetSpace(out var bounds, out var space))
                return false;
            local = Of(bounds, space);
            return true;
        }

        public static Bounds Transform(Matrix4x4 localToWorld, Bounds local)
        {
            Vector3 half = local.size * 0.5f, reach = default;
            for (int axis = 0; axis < 3; axis++)
                reach[axis] = math.abs(localToWorld[axis, 0]) * half.x + math.abs(localToWorld[axis, 1]) * half.y +
                    math.abs(localToWorld[axis, 2]) * half.z;
            return new Bounds(localToWorld.MultiplyPoint3x4(local.center), reach * 2);
        }

        static Bounds Of(BoundsGeo bounds, UnityLocalSpace space)
        {
            double3 a = space.FromGeo(bounds.Min), b = space.FromGeo(bounds.Max);
            return new Bounds(Vector((a + b) * 0.5), Vector(math.abs(b - a)));
        }

        static Vector3 Vector(double3 value) => new Vector3((float)value.x, (float)value.y, (float)value.z);
    }
}
