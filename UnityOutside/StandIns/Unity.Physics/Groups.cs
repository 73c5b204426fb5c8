using Unity.Entities;

namespace Unity.Physics.Systems;

[UpdateInGroup(typeof(FixedStepSimulationSystemGroup))]
public class PhysicsSystemGroup : ComponentSystemGroup { }

[UpdateInGroup(typeof(PhysicsSystemGroup))]
public class BeforePhysicsSystemGroup : ComponentSystemGroup { }
