namespace StandIns.Graphics;

static class PropertyNames
{
    static readonly Dictionary<string, int> s_ids = new Dictionary<string, int>();
    static readonly List<string> s_names = new List<string>();

    internal static int IdOf(string name)
    {
        lock (s_names)
        {
            if (s_ids.TryGetValue(name, out int id))
                return id;
            s_names.Add(name);
            s_ids.Add(name, s_names.Count - 1);
            return s_names.Count - 1;
        }
    }

    internal static string NameOf(int id)
    {
        lock (s_names)
            return id >= 0 && id < s_names.Count ? s_names[id] : "<unknown>";
    }
}
