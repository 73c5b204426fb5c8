using System;
using System.Collections.Generic;
using UnityEditor;

namespace FastPoints.Editor
{
    /// <summary>How many operations each edited cloud has applied, as Undo changes it. It lasts as long as the editor, over
    /// reloads of scripts.</summary>
    internal sealed class AppliedEditCounts : ScriptableSingleton<AppliedEditCounts>
    {
        public string[] Clouds = new string[0]; // Undo restores both.
        public int[] Counts = new int[0];
        readonly Dictionary<string, int> m_applied = new Dictionary<string, int>(); // By cloud: in the journals.

        void OnEnable()
        {
            for (int c = 0; c < Clouds.Length; c++)
                m_applied[Clouds[c]] = Counts[c];
        }

        public void Set(string cloud, int count)
        {
            int at = Array.IndexOf(Clouds, cloud);
            if (at < 0)
            {
                at = Clouds.Length;
                Array.Resize(ref Clouds, at + 1);
                Array.Resize(ref Counts, at + 1);
                Clouds[at] = cloud;
            }
            m_applied[cloud] = Counts[at] = count;
        }

        /// <returns>The clouds whose journals are elsewhere, and where they shall be.</returns>
        public List<(string Cloud, int Count)> TakeChanged()
        {
            var changed = new List<(string, int)>();
            for (int c = 0; c < Clouds.Length; c++)
                if (m_applied.TryGetValue(Clouds[c], out int applied) && applied != Counts[c])
                {
                    m_applied[Clouds[c]] = Counts[c];
                    changed.Add((Clouds[c], Counts[c]));
                }
            return changed;
        }
    }
}
