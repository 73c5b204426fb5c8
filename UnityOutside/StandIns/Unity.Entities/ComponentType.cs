namespace Unity.Entities;

public struct ComponentType : IEquatable<ComponentType>, IComparable<ComponentType>
{
    public enum AccessMode { ReadWrite, ReadOnly, Exclude }

    public TypeIndex TypeIndex;
    public AccessMode AccessModeType;

    public ComponentType(Type type, AccessMode accessModeType = AccessMode.ReadWrite)
    {
        TypeIndex = TypeRegistry.IndexOf(type);
        AccessModeType = accessModeType;
    }

    public static ComponentType ReadWrite<T>() => new ComponentType(typeof(T));
    public static ComponentType ReadOnly<T>() => new ComponentType(typeof(T), AccessMode.ReadOnly);
    public static implicit operator ComponentType(Type type) => new ComponentType(type);
    public static bool operator ==(ComponentType lhs, ComponentType rhs) => lhs.Equals(rhs);
    public static bool operator !=(ComponentType lhs, ComponentType rhs) => !lhs.Equals(rhs);
    public Type GetManagedType() => TypeRegistry.TypeOf(TypeIndex);
    public int CompareTo(ComponentType other) => TypeIndex.Value.CompareTo(other.TypeIndex.Value);
    public bool Equals(ComponentType other) => TypeIndex.Value == other.TypeIndex.Value && AccessModeType == other.AccessModeType;
    public override bool Equals(object obj) => obj is ComponentType other && Equals(other);
    public override int GetHashCode() => TypeIndex.Value;
    public override string ToString() => GetManagedType().Name;
}
