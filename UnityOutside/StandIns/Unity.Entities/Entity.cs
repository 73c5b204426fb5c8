namespace Unity.Entities;

public struct Entity : IEquatable<Entity>, IComparable<Entity>
{
    public int Index;
    public int Version;

    public static Entity Null => default;

    public static bool operator ==(Entity lhs, Entity rhs) => lhs.Index == rhs.Index && lhs.Version == rhs.Version;
    public static bool operator !=(Entity lhs, Entity rhs) => !(lhs == rhs);
    public int CompareTo(Entity other) => Index.CompareTo(other.Index);
    public bool Equals(Entity entity) => this == entity;
    public override bool Equals(object compare) => compare is Entity entity && this == entity;
    public override int GetHashCode() => Index;
    public override string ToString() => this == Null ? "Entity.Null" : "Entity(" + Index + ":" + Version + ")";
}
