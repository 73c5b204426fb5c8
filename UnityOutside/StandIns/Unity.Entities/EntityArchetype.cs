namespace Unity.Entities;

public struct EntityArchetype : IEquatable<EntityArchetype>
{
    internal Archetype Stored;

    public bool Equals(EntityArchetype entityArchetype) => Stored == entityArchetype.Stored;
    public override bool Equals(object compare) => compare is EntityArchetype other && Equals(other);
    public override int GetHashCode() => Stored == null ? 0 : Stored.GetHashCode();
}
