namespace Unity.Entities
{
    [AttributeUsage(AttributeTargets.Class | AttributeTargets.Struct)]
    public class WorldSystemFilterAttribute : Attribute
    {
        public WorldSystemFilterFlags FilterFlags;
        public WorldSystemFilterFlags ChildDefaultFilterFlags;

        public WorldSystemFilterAttribute(WorldSystemFilterFlags flags,
            WorldSystemFilterFlags childDefaultFlags = WorldSystemFilterFlags.Default)
        {
            FilterFlags = flags;
            ChildDefaultFilterFlags = childDefaultFlags;
        }
    }
}
