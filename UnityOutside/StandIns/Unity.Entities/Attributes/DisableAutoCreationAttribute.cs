namespace Unity.Entities;

[AttributeUsage(AttributeTargets.Assembly | AttributeTargets.Class | AttributeTargets.Struct, Inherited = false)]
public sealed class DisableAutoCreationAttribute : Attribute { }
