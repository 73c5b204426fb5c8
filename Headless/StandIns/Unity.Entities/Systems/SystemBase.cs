using Unity.Jobs;

namespace Unity.Entities
{
    public abstract class SystemBase : ComponentSystemBase
    {
        protected JobHandle Dependency { get; set; }

        protected abstract void OnUpdate();

        protected void CompleteDependency() => Dependency.Complete();

        public sealed override void Update()
        {
            if (Begin())
                OnUpdate();
        }
    }
}
