[assembly: InternalsVisibleTo("HostTests")]
[assembly: InternalsVisibleTo("FastPoints.Tests")]

namespace UnityEngine;

public class Collider : Component { }

public class MeshCollider : Collider
{
    Mesh m_mesh;

    internal static int BakedWhereSet { get; set; } // A mesh that was not baked is baked where it is set, on the main thread.

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
