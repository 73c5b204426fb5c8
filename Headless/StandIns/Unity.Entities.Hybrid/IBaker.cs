namespace Unity.Entities
{
    public abstract class IBaker
    {
        internal EntityManager Entities;
        internal Entity Primary;

        public Entity GetEntity(TransformUsageFlags flags) => Primary;

        /// <summary>Everything is baked once: nothing follows from it here.</summary>
        public T DependsOn<T>(T dependency) where T : UnityEngine.Object => dependency;

        public void AddComponent<T>(Entity entity, in T component) where T : unmanaged, IComponentData =>
            Entities.AddComponentData(entity, component);

        public void AddComponentObject<T>(Entity entity, T component) where T : class =>
            Entities.AddComponentObject(entity, component);
    }
}
