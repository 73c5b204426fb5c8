using System;
using System.Collections.Generic;
using FastPoints.Entities;
using FastPoints.Queries;
using Unity.Entities;
using Unity.Mathematics;

namespace FastPoints.Editor
{
    /// <summary>Points that are picked one after the other, two at most, and the text about them.</summary>
    internal sealed class MeasureSession : IDisposable
    {
        readonly ScenePicker m_picker = new ScenePicker();
        readonly List<StreamPick> m_picks = new List<StreamPick>();
        readonly List<Entity> m_clouds = new List<Entity>();
        readonly List<string> m_lines = new List<string>();
        public IReadOnlyList<StreamPick> Picks => m_picks; // The picked points; the second one is measured from the first.

        public IReadOnlyList<string> Lines => m_lines;

        public string Text => string.Join("\n", m_lines);

        public void Begin(PointQuery ray)
        {
            if (m_picks.Count == 2)
                ClearPicks();
            if (m_picker.Begin(ray))
                ShowNote("searching");
            else
                ShowNote("no point cloud is shown");
        }

        /// <summary>Continues the search; called once an update of the editor.</summary>
        /// <returns>Whether there is something new to be drawn.</returns>
        public bool Update(double budgetMs)
        {
            if (!m_picker.IsSearching || !m_picker.Update(budgetMs))
                return false;
            var pick = m_picker.Pick;
            if (pick.Point != null)
            {
                m_picks.Add(pick);
                m_clouds.Add(m_picker.EntityOf(pick.Cloud));
            }
            ShowNote(pick.Failure ?? (pick.Point == null ? "no point here"
                : pick.IsPartial ? "perhaps not the nearest: too many points"
                : pick.IsPreview ? "perhaps not the nearest: not all points are there yet" : null));
            return true;
        }

        public void Clear()
        {
            ClearPicks();
            m_lines.Clear();
        }

        /// <summary>Where a picked point is now, in the world: it moves with its cloud.</summary>
        public double3 PositionOf(int pick) => m_picker.PositionOf(m_picks[pick], m_clouds[pick]);

        public void Dispose() => m_picker.Dispose();

        void ClearPicks()
        {
            m_picks.Clear();
            m_clouds.Clear();
        }

        void ShowNote(string note)
        {
            m_lines.Clear();
            if (m_picks.Count == 2)
                m_lines.AddRange(PickText.Describe(new Measurement(m_picks[0], m_picks[1]), m_picks[1].Point.Grid.Step));
            for (int i = m_picks.Count - 1; i >= 0; i--)
            {
                m_lines.Add(i == 0 ? "From" : "To");
                m_lines.AddRange(PickText.Describe(m_picks[i]));
            }
            if (note != null)
                m_lines.Add(note);
        }
    }
}
