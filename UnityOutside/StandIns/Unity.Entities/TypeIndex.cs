namespace Unity.Entities;

public struct TypeIndex
{
    public int Value;
}
