namespace Unity.Entities;

[AttributeUsage(AttributeTargets.Class | AttributeTargets.Struct, AllowMultiple = true)]
public class UpdateAfterAttribute : Attribute
{
    public UpdateAfterAttribute(Type systemType) => SystemType = systemType
        ?? throw new ArgumentNullException(nameof(systemType));

    public Type SystemType { get; }
}
