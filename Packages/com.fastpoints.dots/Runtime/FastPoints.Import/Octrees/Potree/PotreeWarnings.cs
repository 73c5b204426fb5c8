using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Reading;

namespace FastPoints.Octrees
{
    // The first few anomalies of a kind are reported one by one, the others as a count.
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

        // what: in the same words for all nodes; path: null for the source's own.
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
