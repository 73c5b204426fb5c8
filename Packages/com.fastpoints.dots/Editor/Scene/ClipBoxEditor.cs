using FastPoints.Entities;
using Unity.Mathematics;
using UnityEditor;
using UnityEditor.IMGUI.Controls;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>Handles on the sides of a clip box in the Scene view, which move and scale its GameObject; F frames it.</summary>
    [CustomEditor(typeof(PointCloudClipBox))]
    [CanEditMultipleObjects]
    internal sealed class ClipBoxEditor : UnityEditor.Editor
    {
        /// <summary>A box that was dragged flat could not be dragged open again.</summary>
        const float MinThickness = 1e-3f;

        readonly BoxBoundsHandle m_handle = new BoxBoundsHandle();

        /// <summary>Moves a box to where its handles were dragged.</summary>
        /// <param name="center">Centre in the box's own space, as is <paramref name="size"/>: before, they were 0 and 1.</param>
        public static void Apply(Transform box, Vector3 center, Vector3 size)
        {
            for (int axis = 0; axis < 3; axis++)
                size[axis] = math.max(MinThickness, math.abs(size[axis]));
            box.position = box.localToWorldMatrix.MultiplyPoint3x4(center);
            box.localScale = Vector3.Scale(box.localScale, size);
        }

        // Unity finds these three methods by name, and calls them on each target's editor.

        void OnSceneGUI()
        {
            var box = ((PointCloudClipBox)target).transform;
            var before = Handles.matrix;
            Handles.matrix = box.localToWorldMatrix;
            m_handle.center = Vector3.zero;
            m_handle.size = Vector3.one;
            EditorGUI.BeginChangeCheck();
            m_handle.DrawHandle();
            if (EditorGUI.EndChangeCheck())
            {
                Undo.RecordObject(box, "Change clip box");
                Apply(box, m_handle.center, m_handle.size);
            }
            Handles.matrix = before;
        }

        bool HasFrameBounds() => true;

        Bounds OnGetFrameBounds()
        {
            var bounds = ((PointCloudClipBox)target).WorldBounds;
            foreach (var other in targets)
                bounds.Encapsulate(((PointCloudClipBox)other).WorldBounds);
            return bounds;
        }
    }
}
