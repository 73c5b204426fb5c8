using StandIns.Scene;
using Unity.Entities;
using UnityEngine;
using Object = UnityEngine.Object;

namespace StandIns.Entities;

/// <summary>Bakes one authoring component into one entity, as a subscene's conversion would. What is read without a
/// dependency would be baked once, and never again.</summary>
static class Baking
{
    public static Entity Bake<T>(Baker<T> baker, T authoring, World world) where T : Component
    {
        baker.Entities = world.EntityManager;
        baker.Authoring = authoring;
        baker.Primary = world.EntityManager.CreateEntity();
        baker.Bake(authoring);
        foreach (var field in SerializedFields.Of(typeof(T)))
            if (field.GetValue(authoring) is Object used && !baker.Dependencies.Contains(used))
                throw new InvalidOperationException(baker.GetType().Name + " reads " + field.Name + " and does not depend on it");
        return baker.Primary;
    }
}
