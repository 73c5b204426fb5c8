using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Reading;

namespace FastPoints.Octrees
{
    /// <summary>Anomalies that any of a tree's nodes may have: the first few of a kind are reported one by one, the others as a
    /// count.</summary>
    sealed class PotreeWarnings
    {
        const int MaxReported = 3;

        sealed class Kind
        {
            public int Count;
            public int Warning = -1;
        }

        readonly SourceInfo m_info;
        readonly Dictionary<string, Kind> m_kinds = new Dictionary<string, Kind>();

        public PotreeWarnings(SourceInfo info) => m_info = info;

        /// <summary>Adds a warning about a node.</summary>
        /// <param name="what">The anomaly, in the same words for all nodes.</param>
        /// <param name="detail">A detail about this node, or null.</param>
        /// <param name="byteOffset">Offset in the file that <paramref name="path"/> names, or -1.</param>
        /// <param name="path">Null for the source's own path.</param>
        public void Add(string what, string node, string detail = null, long byteOffset = -1, string path = null)
        {
            if (!m_kinds.TryGetValue(what, out var kind))
                m_kinds.Add(what, kind = new Kind());
            kind.Count++;
            if (kind.Count <= MaxReported)
            {
                m_info.Warnings.Add(new CloudWarning(path ?? m_info.Path, byteOffset,
                    "node " + node + ": " + what + (detail != null ? ": " + detail : "")));
                return;
            }
            var others = new CloudWarning(m_info.Path, -1, NumberText.Of(kind.Count - MaxReported) + " more nodes: " + what);
            if (kind.Warning < 0)
            {
                kind.Warning = m_info.Warnings.Count;
                m_info.Warnings.Add(others);
            }
            m_info.Warnings[kind.Warning] = others;
        }
    }
}
