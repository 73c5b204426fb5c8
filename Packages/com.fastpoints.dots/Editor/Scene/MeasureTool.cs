using FastPoints.Queries;
using UnityEditor;
using UnityEditor.EditorTools;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>The Scene view's tool <em>Measure points</em>: a click picks a point and shows its coordinates and attributes, a
    /// second one the distance; Escape starts over.</summary>
    [EditorTool("Measure points")]
    internal sealed class MeasureTool : PointTool<MeasureSession>
    {
        protected override bool Advance(double budgetMs) => Session.Update(budgetMs);

        protected override void Press(PointQuery ray) => Session.Begin(ray);

        protected override bool Escape(bool isDragging)
        {
            bool isShown = Session.Lines.Count > 0;
            Session.Clear();
            return isShown;
        }

        protected override void DrawMarks(Vector3 toCamera)
        {
            for (int i = 0; i < Session.Picks.Count; i++)
            {
                var position = PositionOf(i);
                Handles.DrawWireDisc(position, toCamera, HandleUtility.GetHandleSize(position) * 0.05f);
                Handles.Label(position, i == 0 ? "From" : "To");
            }
            if (Session.Picks.Count == 2)
                Handles.DrawLine(PositionOf(0), PositionOf(1));
        }

        protected override void DrawPanel()
        {
            foreach (string line in Session.Lines)
                GUILayout.Label(line);
            if (Session.Lines.Count > 0 && GUILayout.Button("Copy"))
                GUIUtility.systemCopyBuffer = Session.Text;
        }

        Vector3 PositionOf(int pick) => ToVector(Session.PositionOf(pick));
    }
}
