namespace Unity.Entities;

[AttributeUsage(AttributeTargets.Class | AttributeTargets.Struct)]
public class WorldSystemFilterAttribute(WorldSystemFilterFlags flags,
    WorldSystemFilterFlags childDefaultFlags = WorldSystemFilterFlags.Default) : Attribute
{
    public WorldSystemFilterFlags FilterFlags = flags;
    public WorldSystemFilterFlags ChildDefaultFilterFlags = childDefaultFlags;
}
