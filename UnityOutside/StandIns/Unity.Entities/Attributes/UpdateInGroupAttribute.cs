namespace Unity.Entities;

[AttributeUsage(AttributeTargets.Class | AttributeTargets.Struct, AllowMultiple = true)]
public class UpdateInGroupAttribute : Attribute
{
    public bool OrderFirst;
    public bool OrderLast;

    public UpdateInGroupAttribute(Type groupType) => GroupType = groupType ?? throw new ArgumentNullException(nameof(groupType));

    public Type GroupType { get; }
}
