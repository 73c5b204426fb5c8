namespace StandIns.Entities;

static class TypeRegistry
{
    static readonly List<ComponentInfo> s_infos = new List<ComponentInfo>();
    static readonly Dictionary<Type, int> s_indexOfType = new Dictionary<Type, int>();

    public static class Of<T>
    {
        public static readonly TypeIndex Index = IndexOf(typeof(T));
    }

    public static TypeIndex IndexOf(Type type)
    {
        lock (s_infos)
        {
            if (!s_indexOfType.TryGetValue(type, out int index))
            {
                index = s_infos.Count;
                s_infos.Add(new ComponentInfo(type));
                s_indexOfType.Add(type, index);
            }
            return new TypeIndex { Value = index };
        }
    }

    public static Type TypeOf(TypeIndex index) => InfoOf(index.Value).Type;

    public static ComponentInfo InfoOf(int index)
    {
        lock (s_infos)
            return s_infos[index];
    }
}
