namespace UnityEngine;

public class Physics
{
    /// <summary>For any thread. What Unity does with the number of a mesh that is gone is not known: it is refused.</summary>
#if UNITY_6000_3_OR_NEWER
    public static void BakeMesh(EntityId meshEntityId, bool convex) => Bake(meshEntityId.Id);
#else
    public static void BakeMesh(int meshID, bool convex) => Bake(meshID);
#endif

    static void Bake(int id)
    {
        var mesh = Mesh.Find(id) ?? throw new InvalidOperationException("no mesh has the number " + id);
        mesh.IsBaked = true;
    }
}
