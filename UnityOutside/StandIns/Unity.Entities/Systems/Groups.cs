namespace Unity.Entities;

public class InitializationSystemGroup : ComponentSystemGroup { }

public class SimulationSystemGroup : ComponentSystemGroup { }

public class PresentationSystemGroup : ComponentSystemGroup { }
