namespace Unity.Entities;

public static class DefaultWorldInitialization
{
    /// <summary>The host has no world but the one that it makes itself.</summary>
    public static void DefaultLazyEditModeInitialize() { }

    /// <summary>Makes the systems, and puts each into the group that its attribute names: into Simulation where it names
    /// none. A group that nobody has made is not made: what should be in it never runs.</summary>
    public static void AddSystemsToRootLevelSystemGroups(World world, params Type[] systemTypes)
    {
        world.GetOrCreateSystemManaged<InitializationSystemGroup>();
        world.GetOrCreateSystemManaged<SimulationSystemGroup>();
        world.GetOrCreateSystemManaged<PresentationSystemGroup>();
        foreach (var type in systemTypes)
            World.Try(() => world.GetOrCreateSystemManaged(type));
        foreach (var type in systemTypes)
            Add(world, type);
        world.GetExistingSystemManaged<InitializationSystemGroup>().SortSystems();
        world.GetExistingSystemManaged<SimulationSystemGroup>().SortSystems();
        world.GetExistingSystemManaged<PresentationSystemGroup>().SortSystems();
    }

    static void Add(World world, Type type)
    {
        bool isRoot = type == typeof(InitializationSystemGroup) || type == typeof(SimulationSystemGroup) ||
            type == typeof(PresentationSystemGroup);
        if (isRoot)
            return;
        var group = type.GetCustomAttribute<UpdateInGroupAttribute>()?.GroupType ?? typeof(SimulationSystemGroup);
        if (!typeof(ComponentSystemGroup).IsAssignableFrom(group))
            throw new InvalidOperationException($"Invalid [UpdateInGroupAttribute] attribute for {type}: "
                + "target group must be derived from ComponentSystemGroup.");
        if (world.GetExistingSystemManaged(type) == null)
            return;
        if (world.GetExistingSystemManaged(group) is ComponentSystemGroup made)
            made.AddSystemToUpdateList(world.GetExistingSystemManaged(type));
        else
            UnityEngine.Debug.LogWarning($"A system {type} could not be added to group {group.Name}, because the group was "
                + $"not created in the world {world.Name}.");
    }
}
