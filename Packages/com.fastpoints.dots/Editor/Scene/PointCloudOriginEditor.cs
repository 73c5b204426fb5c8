using FastPoints.Entities;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Editor
{
    [CustomEditor(typeof(PointCloudOrigin))]
    internal sealed class PointCloudOriginEditor : UnityEditor.Editor
    {
        public override void OnInspectorGUI()
        {
            var origin = (PointCloudOrigin)target;
            var before = origin.PositionGeo;
            serializedObject.Update();
            DrawPropertiesExcluding(serializedObject, "m_Script");
            // A typed position sets the origin; a coordinate system alone does not.
            if (serializedObject.ApplyModifiedProperties() && !origin.PositionGeo.Equals(before))
                Change(origin, "Set origin", () => origin.PositionGeo = origin.PositionGeo);
            if (!origin.HasPosition)
                EditorGUILayout.HelpBox("The first cloud beneath this GameObject will decide on the place.", MessageType.Info);
            var cloud = (PointCloud)EditorGUILayout.ObjectField("Align to", null, typeof(PointCloud), true);
            if (cloud != null)
                Change(origin, "Align origin", () => origin.AlignTo(cloud));
            if (GUILayout.Button("Set origin here") && SceneView.lastActiveSceneView is { } view)
                SetHere(origin, view.pivot);
        }

        /// <summary>Makes the middle of the Scene view the origin, which moves to its GameObject.</summary>
        internal static void SetHere(PointCloudOrigin origin, Vector3 pivot)
        {
            var offset = pivot - origin.transform.position;
            Change(origin, "Set origin", () => origin.Shift(new Unity.Mathematics.double3(offset.x, offset.y, offset.z)));
        }

        static void Change(PointCloudOrigin origin, string name, System.Action change)
        {
            Undo.RecordObject(origin, name);
            change();
            EditorUtility.SetDirty(origin);
            EditorApplication.QueuePlayerLoopUpdate();
        }
    }
}
