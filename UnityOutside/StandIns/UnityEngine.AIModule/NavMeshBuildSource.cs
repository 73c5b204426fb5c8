namespace UnityEngine.AI;

public enum NavMeshBuildSourceShape { Mesh = 0, Terrain = 1, Box = 2, Sphere = 3, Capsule = 4, ModifierBox = 5 }

public struct NavMeshBuildSource
{
    public Matrix4x4 transform { get; set; }
    public NavMeshBuildSourceShape shape { get; set; }
    public Object sourceObject { get; set; }
    public Component component { get; set; }
}
