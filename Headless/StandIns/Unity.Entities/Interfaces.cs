namespace Unity.Entities;

public interface IQueryTypeParameter { }

public interface IComponentData : IQueryTypeParameter { }

public interface ICleanupComponentData : IComponentData { }

public interface IEnableableComponent { }

/// <summary>Queries that do not name it leave out what has it.</summary>
public struct Prefab : IComponentData { }
