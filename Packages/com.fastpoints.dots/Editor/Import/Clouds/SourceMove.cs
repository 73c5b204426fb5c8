using System.IO;

namespace FastPoints.Editor
{
    /// <summary>Where sources have gone, as one of them shows that was found again: what lay beside it, or in folders of its
    /// path that are called as before, has moved along.</summary>
    internal sealed class SourceMove
    {
        readonly string m_from;
        readonly string m_to;

        /// <param name="from">The absolute path of a file or folder that is not there.</param>
        /// <param name="to">Where it is now.</param>
        public SourceMove(string from, string to)
        {
            (m_from, m_to) = (from, to);
            while (Path.GetFileName(m_from) == Path.GetFileName(m_to) && Path.GetDirectoryName(m_from) is { } fromFolder &&
                Path.GetDirectoryName(m_to) is { } toFolder && fromFolder.Length > 1 && toFolder.Length > 1)
                (m_from, m_to) = (fromFolder, toFolder);
        }

        /// <summary>Where a source is that has moved along; null for one that is where it was, or not there either.</summary>
        public string Find(string source)
        {
            if (Exists(source))
                return null;
            string to = source == m_from ? m_to : source.StartsWith(m_from + Path.DirectorySeparatorChar,
                System.StringComparison.Ordinal)
                ? m_to + source.Substring(m_from.Length) : null;
            return to != null && Exists(to) ? to : null;
        }

        static bool Exists(string path) => File.Exists(path) || Directory.Exists(path);
    }
}
