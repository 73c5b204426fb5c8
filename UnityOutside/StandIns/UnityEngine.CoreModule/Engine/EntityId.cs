namespace UnityEngine;

/// <summary>An object's number from 6000.3 on.</summary>
public struct EntityId
{
    internal int Id;
}
