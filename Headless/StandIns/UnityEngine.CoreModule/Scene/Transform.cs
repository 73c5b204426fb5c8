namespace UnityEngine
{
    /// <summary>A place without parents: the matrix is set by whoever tests.</summary>
    public class Transform : Component
    {
        public Matrix4x4 localToWorldMatrix { get; internal set; } = Matrix4x4.identity;

        public Vector3 position => new Vector3(localToWorldMatrix.m03, localToWorldMatrix.m13, localToWorldMatrix.m23);
    }
}
