using Unity.Mathematics;
using Unity.Transforms;
using UnityEngine;

namespace FastPoints.Entities
{
    /// <summary>Where a GameObject stands, as entities have it.</summary>
    static class TransformMatrix
    {
        public static LocalToWorld Of(Transform transform)
        {
            var matrix = transform.localToWorldMatrix;
            return new LocalToWorld
            {
                Value = new float4x4(
                    new float4(matrix.m00, matrix.m10, matrix.m20, matrix.m30),
                    new float4(matrix.m01, matrix.m11, matrix.m21, matrix.m31),
                    new float4(matrix.m02, matrix.m12, matrix.m22, matrix.m32),
                    new float4(matrix.m03, matrix.m13, matrix.m23, matrix.m33)),
            };
        }
    }
}
