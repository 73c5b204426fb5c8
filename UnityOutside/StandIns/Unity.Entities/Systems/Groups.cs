namespace Unity.Entities;

public class InitializationSystemGroup : ComponentSystemGroup { }

public class SimulationSystemGroup : ComponentSystemGroup { }

[UpdateInGroup(typeof(SimulationSystemGroup), OrderFirst = true)]
public class FixedStepSimulationSystemGroup : ComponentSystemGroup { }

public class PresentationSystemGroup : ComponentSystemGroup { }
