using FastPoints.Rendering;
using Unity.Mathematics;
using UnityEditor;
using UnityEditor.EditorTools;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>The Scene view's tool <em>Measure points</em>: a click picks a point and shows its coordinates and attributes, a
    /// second one the distance; Escape starts over.</summary>
    [EditorTool("Measure points")]
    internal sealed class MeasureTool : EditorTool
    {
        const double Radius = 5; // How far from the pointer a point may be, in points of the window.

        const double UpdateMs = 2;

        const float LineHeight = 18;

        MeasureSession m_session;
        public MeasureSession Session => m_session; // Null while the tool is not active.

        public override void OnActivated()
        {
            m_session = new MeasureSession();
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
            // The text comes before clicks are taken, so that a click on its button stays its own.
            DrawText();
            var current = Event.current;
            switch (current.GetTypeForControl(control))
            {
                case EventType.Layout:
                    // Without this a click would also select what is under it.
                    HandleUtility.AddDefaultControl(control);
                    break;
                case EventType.MouseDown when current.button == 0 && !current.alt && HandleUtility.nearestControl == control:
                    m_session.Begin(CameraViews.PickQueryOf(view.camera, HandleUtility.GUIPointToWorldRay(current.mousePosition),
                        Radius * EditorGUIUtility.pixelsPerPoint));
                    GUIUtility.hotControl = control;
                    current.Use();
                    break;
                case EventType.MouseUp when GUIUtility.hotControl == control:
                    GUIUtility.hotControl = 0;
                    current.Use();
                    break;
                case EventType.KeyDown when current.keyCode == KeyCode.Escape && m_session.Lines.Count > 0:
                    m_session.Clear();
                    current.Use();
                    break;
                case EventType.Repaint:
                    DrawMarks(view.camera);
                    break;
            }
        }

        void Update()
        {
            if (m_session.Update(UpdateMs))
                SceneView.RepaintAll();
        }

        void DrawMarks(Camera camera)
        {
            var toCamera = -(Vector3)camera.worldToCameraMatrix.GetRow(2);
            for (int i = 0; i < m_session.Picks.Count; i++)
            {
                var position = PositionOf(i);
                Handles.DrawWireDisc(position, toCamera, HandleUtility.GetHandleSize(position) * 0.05f);
                Handles.Label(position, i == 0 ? "From" : "To");
            }
            if (m_session.Picks.Count == 2)
                Handles.DrawLine(PositionOf(0), PositionOf(1));
        }

        void DrawText()
        {
            if (m_session.Lines.Count == 0)
                return;
            Handles.BeginGUI();
            GUILayout.BeginArea(new Rect(50, 10, 480, (m_session.Lines.Count + 2) * LineHeight));
            foreach (string line in m_session.Lines)
                GUILayout.Label(line);
            if (GUILayout.Button("Copy"))
                GUIUtility.systemCopyBuffer = m_session.Text;
            GUILayout.EndArea();
            Handles.EndGUI();
        }

        Vector3 PositionOf(int pick)
        {
            var position = (float3)m_session.PositionOf(pick);
            return new Vector3(position.x, position.y, position.z);
        }
    }
}
