namespace StandIns.Graphics;

sealed class KeywordSet
{
    internal static readonly KeywordSet Global = new KeywordSet();

    readonly HashSet<string> m_names = new HashSet<string>();

    internal bool Contains(string keyword) => m_names.Contains(keyword);

    internal void Set(string keyword, bool isOn)
    {
        if (isOn)
            m_names.Add(keyword);
        else
            m_names.Remove(keyword);
    }

    internal void CopyFrom(KeywordSet other)
    {
        m_names.Clear();
        m_names.UnionWith(other.m_names);
    }
}
