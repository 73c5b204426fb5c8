namespace UnityEngine
{
    /// <summary>A place without parents: the matrix is set by whoever tests.</summary>
    public class Transform : Component
    {
        public Matrix4x4 localToWorldMatrix { get; internal set; } = Matrix4x4.identity;

        public Vector3 position
        {
            get => new Vector3(localToWorldMatrix.m03, localToWorldMatrix.m13, localToWorldMatrix.m23);
            set
            {
                var moved = localToWorldMatrix;
                (moved.m03, moved.m13, moved.m23) = (value.x, value.y, value.z);
                localToWorldMatrix = moved;
            }
        }

        internal Transform Parent { get; private set; }

        /// <summary>Remembered, but the matrix stays its own.</summary>
        public void SetParent(Transform parent, bool worldPositionStays) => Parent = parent;
    }
}
