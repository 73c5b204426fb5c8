namespace Unity.Entities;

[Flags]
public enum EntityQueryOptions { Default = 0, IncludePrefab = 1, IncludeDisabledEntities = 2 }

/// <summary>Queries leave out an entity with it, unless they name it or ask for such entities.</summary>
public struct Disabled : IComponentData { }
