using System;
using FastPoints.Entities;
using FastPoints.Rendering;
using FastPoints.Store;
using Unity.Mathematics;
using UnityEditor;
using UnityEditor.EditorTools;
using UnityEditor.IMGUI.Controls;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>The Scene view's tool <em>Edit points</em>: a brush, dragged over points, or a box around them deletes, hides,
    /// classifies or colours points of converted clouds. Escape drops a stroke.</summary>
    [EditorTool("Edit points")]
    internal sealed class EditTool : EditorTool
    {
        /// <summary>How far from the pointer a point may be, in points of the window.</summary>
        const double PickRadius = 5;

        /// <summary>Main-thread time of each update.</summary>
        const double UpdateMs = 2;

        const float LineHeight = 22;

        static readonly string[] s_actions = { "Hide", "Delete", "Classify", "Colour" };

        readonly BoxBoundsHandle m_box = new BoxBoundsHandle();
        PointCloud m_boxed;
        bool m_isBox;
        EditSession m_session;

        /// <summary>Null while the tool is not active.</summary>
        public EditSession Session => m_session;

        public override void OnActivated()
        {
            m_session = new EditSession();
            EditorApplication.update += Update;
        }

        /// <summary>Unity calls this before scripts are reloaded, too.</summary>
        public override void OnWillBeDeactivated()
        {
            EditorApplication.update -= Update;
            m_session?.Dispose();
            m_session = null;
        }

        public override void OnToolGUI(EditorWindow window)
        {
            if (m_session == null || !(window is SceneView view))
                return;
            int control = GUIUtility.GetControlID(FocusType.Passive);
            // It comes before clicks are taken, so that a click on a button stays its own.
            DrawPanel();
            if (m_isBox)
                DrawBox();
            else
                Brush(view, control);
        }

        void Brush(SceneView view, int control)
        {
            var current = Event.current;
            switch (current.GetTypeForControl(control))
            {
                case EventType.Layout:
                    // Without this a click would also select what is under it.
                    HandleUtility.AddDefaultControl(control);
                    break;
                case EventType.MouseDown when current.button == 0 && !current.alt && HandleUtility.nearestControl == control:
                    GUIUtility.hotControl = control;
                    Drag(view);
                    break;
                case EventType.MouseDrag when GUIUtility.hotControl == control:
                    Drag(view);
                    break;
                case EventType.MouseUp when GUIUtility.hotControl == control:
                    GUIUtility.hotControl = 0;
                    m_session.EndStroke();
                    current.Use();
                    break;
                case EventType.KeyDown when current.keyCode == KeyCode.Escape && GUIUtility.hotControl == control:
                    GUIUtility.hotControl = 0;
                    m_session.ClearStroke();
                    current.Use();
                    break;
                case EventType.Repaint:
                    DrawStroke(view.camera);
                    break;
            }
        }

        void Drag(SceneView view)
        {
            m_session.Drag(CameraViews.PickRayOf(view.camera, HandleUtility.GUIPointToWorldRay(Event.current.mousePosition),
                PickRadius * EditorGUIUtility.pixelsPerPoint));
            Event.current.Use();
        }

        void Update()
        {
            if (m_session.Update(UpdateMs))
                SceneView.RepaintAll();
        }

        void DrawStroke(Camera camera)
        {
            var toCamera = -(Vector3)camera.worldToCameraMatrix.GetRow(2);
            foreach (var pick in m_session.Stroke)
            {
                var at = (float3)pick.Point.PositionWorld;
                Handles.DrawWireDisc(new Vector3(at.x, at.y, at.z), toCamera, m_session.Radius);
            }
        }

        void DrawBox()
        {
            var cloud = SceneExport.Selected;
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

        void DrawPanel()
        {
            Handles.BeginGUI();
            GUILayout.BeginArea(new Rect(50, 10, 300, 5 * LineHeight));
            GUILayout.BeginHorizontal();
            m_isBox = !GUILayout.Toggle(!m_isBox, "Brush");
            m_isBox = GUILayout.Toggle(m_isBox, "Box");
            GUILayout.EndHorizontal();
            GUILayout.BeginHorizontal();
            for (int action = 0; action < s_actions.Length; action++)
                if (GUILayout.Toggle((int)m_session.Action == action, s_actions[action]))
                    m_session.Action = (EditAction)action;
            GUILayout.EndHorizontal();
            m_session.Class = (byte)math.clamp(EditorGUILayout.IntField("Class", m_session.Class), 0, byte.MaxValue);
            m_session.Color = EditorGUILayout.ColorField("Colour", m_session.Color);
            if (!m_isBox)
                m_session.Radius = math.max(1e-3f, EditorGUILayout.FloatField("Radius", m_session.Radius));
            else if (GUILayout.Button("Apply") && SceneExport.Selected is PointCloud cloud && cloud != null)
                m_session.ApplyBox(cloud, new Bounds(m_box.center, m_box.size));
            GUILayout.Label(CloudEdits.IsBusy ? "editing" : m_session.Note ??
                (m_isBox && SceneExport.Selected == null ? "select a point cloud" : ""));
            GUILayout.EndArea();
            Handles.EndGUI();
        }
    }
}
