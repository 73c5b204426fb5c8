namespace Unity.Entities;

public interface IQueryTypeParameter { }

public interface IComponentData : IQueryTypeParameter { }

public interface ICleanupComponentData : IComponentData { }

public interface IBufferElementData { }

/// <summary>Values of one are shared by chunks; here entities have the default alone.</summary>
public interface ISharedComponentData : IQueryTypeParameter { }

public interface IEnableableComponent { }

[AttributeUsage(AttributeTargets.Struct)]
public class InternalBufferCapacityAttribute(int capacity) : Attribute
{
    public readonly int Capacity = capacity;
}

/// <summary>The entities that are instantiated and destroyed with one: its own first.</summary>
[InternalBufferCapacity(0)]
public struct LinkedEntityGroup : IBufferElementData
{
    public Entity Value;
}

/// <summary>Queries that do not name it leave out what has it.</summary>
public struct Prefab : IComponentData { }
