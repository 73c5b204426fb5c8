using FastPoints.Entities;
using FastPoints.Queries;
using FastPoints.Store;
using Unity.Mathematics;
using UnityEditor;
using UnityEditor.EditorTools;
using UnityEditor.IMGUI.Controls;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>The Scene view's tool <em>Edit points</em>: a brush, dragged over points, a box around them, or a lasso around
    /// what the camera sees of the selected cloud, deletes, hides, classifies or colours points of converted clouds. Escape drops
    /// a stroke or a lasso.</summary>
    [EditorTool("Edit points")]
    internal sealed class EditTool : PointTool<EditSession>
    {
        const int Brush = 0, Box = 1, Lasso = 2;

        static readonly string[] s_shapes = { "Brush", "Box", "Lasso" };
        static readonly string[] s_actions = { "Hide", "Delete", "Classify", "Colour" };

        readonly BoxBoundsHandle m_box = new BoxBoundsHandle();
        PointCloud m_boxed;
        int m_shape;

        protected override bool TakesClicks => m_shape != Box;

        protected override bool Advance(double budgetMs) => Session.Update(budgetMs);

        protected override void Press(PointQuery ray) => Drag(ray);

        protected override void Drag(PointQuery ray)
        {
            if (m_shape == Lasso)
                Session.Lasso.Add(ray);
            else
                Session.Drag(ray);
        }

        protected override void Release()
        {
            if (m_shape == Brush)
                Session.EndStroke();
            else if (Selected is PointCloud cloud)
                Session.ApplyLasso(cloud);
            Session.Lasso.Clear();
        }

        protected override bool Escape(bool isDragging)
        {
            if (isDragging)
            {
                GUIUtility.hotControl = 0;
                Session.ClearStroke();
                Session.Lasso.Clear();
            }
            return isDragging;
        }

        static PointCloud Selected => SceneExport.Selected != null ? SceneExport.Selected : null;

        protected override void DrawMarks(Vector3 toCamera)
        {
            foreach (var pick in Session.Stroke)
                Handles.DrawWireDisc(ToVector(pick.Point.PositionWorld), toCamera, Session.Radius);
            for (int i = 0; i < Session.Lasso.Count; i++)
                Handles.DrawLine(BeforeCamera(Session.Lasso[i]), BeforeCamera(Session.Lasso[(i + 1) % Session.Lasso.Count]));
        }

        static Vector3 BeforeCamera(in PointQuery ray) => ToVector(ray.OriginWorld + ray.DirectionWorld * (2 * ray.From + 1));

        protected override void DrawHandles()
        {
            var cloud = m_shape == Box ? Selected : null;
            if (cloud == null)
                return;
            if (m_boxed != cloud && cloud.TryGetLocalBounds(out var bounds))
                (m_boxed, m_box.center, m_box.size) = (cloud, bounds.center, bounds.size * 0.2f);
            var before = Handles.matrix;
            // Its sides lie along the cloud's axes, however it is turned.
            Handles.matrix = cloud.transform.localToWorldMatrix;
            m_box.DrawHandle();
            Handles.matrix = before;
        }

        protected override void DrawPanel()
        {
            m_shape = Choose(s_shapes, m_shape);
            Session.Action = (EditAction)Choose(s_actions, (int)Session.Action);
            Session.Class = (byte)math.clamp(EditorGUILayout.IntField("Class", Session.Class), 0, byte.MaxValue);
            Session.Color = EditorGUILayout.ColorField("Colour", Session.Color);
            if (m_shape == Brush)
                Session.Radius = math.max(1e-3f, EditorGUILayout.FloatField("Radius", Session.Radius));
            else if (m_shape == Box && GUILayout.Button("Apply") && Selected is PointCloud cloud)
                Session.ApplyBox(cloud, new Bounds(m_box.center, m_box.size));
            GUILayout.Label(EditQueue.IsBusy ? "editing" : Session.Note ??
                (m_shape != Brush && Selected == null ? "select a point cloud" : ""));
        }

        static int Choose(string[] names, int chosen)
        {
            GUILayout.BeginHorizontal();
            for (int i = 0; i < names.Length; i++)
                if (GUILayout.Toggle(chosen == i, names[i]))
                    chosen = i;
            GUILayout.EndHorizontal();
            return chosen;
        }
    }
}
