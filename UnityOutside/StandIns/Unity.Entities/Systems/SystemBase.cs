using Unity.Jobs;

namespace Unity.Entities;

public abstract class SystemBase : ComponentSystemBase
{
    protected JobHandle Dependency { get; set; }

    protected abstract void OnUpdate();

    public sealed override void Update()
    {
        if (!Begin())
            return;
        var world = World;
        world.Executing++;
        try
        {
            OnUpdate();
        }
        finally
        {
            world.Executing--;
            // What a system has scheduled and says so, the engine starts; other jobs wait.
            if (!Dependency.Equals(default))
                JobHandle.ScheduleBatchedJobs();
        }
    }
}
