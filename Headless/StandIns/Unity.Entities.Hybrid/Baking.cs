using Unity.Entities;
using UnityEngine;

namespace StandIns.Entities
{
    /// <summary>Bakes one authoring component into one entity, as a subscene's conversion would.</summary>
    static class Baking
    {
        public static Entity Bake<T>(Baker<T> baker, T authoring, World world) where T : Component
        {
            baker.Entities = world.EntityManager;
            baker.Primary = world.EntityManager.CreateEntity();
            baker.Bake(authoring);
            return baker.Primary;
        }
    }
}
