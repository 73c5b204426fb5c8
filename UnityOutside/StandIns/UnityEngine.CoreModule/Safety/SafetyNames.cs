namespace StandIns.Safety;

static class SafetyNames
{
    static readonly object s_lock = new object();
    static readonly List<string> s_names = new List<string> { "native container" };
    static readonly Dictionary<string, int> s_ids = new Dictionary<string, int>();

    internal static int IdOf(string name)
    {
        lock (s_lock)
        {
            if (s_ids.TryGetValue(name, out int id))
                return id;
            s_names.Add(name);
            s_ids.Add(name, s_names.Count - 1);
            return s_names.Count - 1;
        }
    }

    internal static string Of(int id)
    {
        lock (s_lock)
            return s_names[id];
    }

    /// <summary>A type as Unity's messages write it: Unity.Collections.NativeArray`1[System.Int32].</summary>
    internal static string Of(Type type) => type.ToString();
}
