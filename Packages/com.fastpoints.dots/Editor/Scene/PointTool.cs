using System;
using FastPoints.Queries;
using FastPoints.Rendering;
using Unity.Mathematics;
using UnityEditor;
using UnityEditor.EditorTools;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>A tool of the Scene view that is clicked and dragged over points; its work is a session's, which is there while
    /// the tool is active.</summary>
    internal abstract class PointTool<TSession> : EditorTool where TSession : class, IDisposable, new()
    {
        const double PickRadius = 5; // How far from the pointer a point may be, in points of the window.
        const double UpdateMs = 2; // Main-thread time of each update.

        public TSession Session { get; private set; }

        protected virtual bool TakesClicks => true;

        public override void OnActivated()
        {
            Session = new TSession();
            EditorApplication.update += Update;
        }

        /// <summary>Unity calls this before scripts are reloaded, too.</summary>
        public override void OnWillBeDeactivated()
        {
            EditorApplication.update -= Update;
            Session?.Dispose();
            Session = null;
        }

        public override void OnToolGUI(EditorWindow window)
        {
            if (Session == null || !(window is SceneView view))
                return;
            int control = GUIUtility.GetControlID(FocusType.Passive);
            // It comes before clicks are taken, so that a click on a button stays its own.
            Handles.BeginGUI();
            GUILayout.BeginArea(new Rect(50, 10, 480, view.camera.pixelHeight));
            DrawPanel();
            GUILayout.EndArea();
            Handles.EndGUI();
            DrawHandles();
            if (!TakesClicks)
                return;
            var current = Event.current;
            switch (current.GetTypeForControl(control))
            {
                case EventType.Layout:
                    // Without this a click would also select what is under it.
                    HandleUtility.AddDefaultControl(control);
                    break;
                case EventType.MouseDown when current.button == 0 && !current.alt && HandleUtility.nearestControl == control:
                    GUIUtility.hotControl = control;
                    Press(RayOf(view.camera));
                    current.Use();
                    break;
                case EventType.MouseDrag when GUIUtility.hotControl == control:
                    Drag(RayOf(view.camera));
                    current.Use();
                    break;
                case EventType.MouseUp when GUIUtility.hotControl == control:
                    GUIUtility.hotControl = 0;
                    Release();
                    current.Use();
                    break;
                case EventType.KeyDown when current.keyCode == KeyCode.Escape && Escape(GUIUtility.hotControl == control):
                    current.Use();
                    break;
                case EventType.Repaint:
                    DrawMarks(-(Vector3)view.camera.worldToCameraMatrix.GetRow(2));
                    break;
            }
        }

        protected static Vector3 ToVector(double3 position)
        {
            var at = (float3)position;
            return new Vector3(at.x, at.y, at.z);
        }

        protected abstract bool Advance(double budgetMs);

        protected abstract void DrawPanel();

        protected virtual void DrawHandles() { }

        protected abstract void DrawMarks(Vector3 toCamera);

        protected abstract void Press(PointQuery ray);

        protected virtual void Drag(PointQuery ray) { }

        protected virtual void Release() { }

        protected abstract bool Escape(bool isDragging);

        void Update()
        {
            if (Advance(UpdateMs))
                SceneView.RepaintAll();
        }

        static PointQuery RayOf(Camera camera) => CameraViews.PickQueryOf(camera,
            HandleUtility.GUIPointToWorldRay(Event.current.mousePosition), PickRadius * EditorGUIUtility.pixelsPerPoint);
    }
}
