[assembly: InternalsVisibleTo("HostTests")]
[assembly: InternalsVisibleTo("FastPoints.Tests")]

namespace UnityEngine;

public class Collider : Component { }

public class MeshCollider : Collider
{
    Mesh m_mesh;

    /// <summary>A mesh that was not baked is baked where it is set, on the main thread.</summary>
    internal static int BakedWhereSet { get; set; }

    public Mesh sharedMesh
    {
        get => There(m_mesh);
        set
        {
            CheckIsThere();
            if (value != null && !value.IsBaked)
            {
                BakedWhereSet++;
                value.IsBaked = true;
            }
            m_mesh = value;
        }
    }
}
