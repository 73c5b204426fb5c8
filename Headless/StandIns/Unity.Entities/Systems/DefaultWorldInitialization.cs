using System;
using System.Reflection;

namespace Unity.Entities
{
    public static class DefaultWorldInitialization
    {
        /// <summary>The host has no world but the one that it makes itself.</summary>
        public static void DefaultLazyEditModeInitialize()
        {
        }

        /// <summary>Makes the systems, and puts each into the group that its attribute names: into Simulation where it names
        /// none.</summary>
        public static void AddSystemsToRootLevelSystemGroups(World world, params Type[] systemTypes)
        {
            Add(world, typeof(InitializationSystemGroup));
            Add(world, typeof(SimulationSystemGroup));
            Add(world, typeof(PresentationSystemGroup));
            foreach (var type in systemTypes)
                Add(world, type);
        }

        static void Add(World world, Type type)
        {
            var system = world.GetOrCreateSystemManaged(type);
            bool isRoot = type == typeof(InitializationSystemGroup) || type == typeof(SimulationSystemGroup) ||
                type == typeof(PresentationSystemGroup);
            if (isRoot)
                return;
            var group = type.GetCustomAttribute<UpdateInGroupAttribute>()?.GroupType ?? typeof(SimulationSystemGroup);
            // A group may have been made by a system that asked for it.
            Add(world, group);
            ((ComponentSystemGroup)world.GetExistingSystemManaged(group)).AddSystemToUpdateList(system);
        }
    }
}
