namespace UnityEngine;

[AttributeUsage(AttributeTargets.Class, Inherited = false)]
public sealed class DisallowMultipleComponent : Attribute { }

[AttributeUsage(AttributeTargets.Class, AllowMultiple = true)]
public sealed class RequireComponent(Type requiredComponent) : Attribute
{
    public Type m_Type0 = requiredComponent;
}

public sealed class ExecuteAlways : Attribute { }

public sealed class AddComponentMenu(string menuName) : Attribute
{
    public string componentMenu { get; } = menuName;
}
