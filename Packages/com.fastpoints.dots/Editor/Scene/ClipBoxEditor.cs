using System.Collections.Generic;
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
        const float MinThickness = 1e-3f; // A box that was dragged flat could not be dragged open again.

        readonly Dictionary<Object, BoxHandle> m_handles = new Dictionary<Object, BoxHandle>();

        // Unity finds these three methods by name, and calls them on each target's editor.

        void OnSceneGUI()
        {
            var box = ((PointCloudClipBox)target).transform;
            if (!m_handles.TryGetValue(target, out var handle))
                m_handles.Add(target, handle = new BoxHandle());
            if (!handle.IsDragged)
                handle.Fit(box);
            bool isFree = GUIUtility.hotControl == 0;
            var before = Handles.matrix;
            Handles.matrix = handle.Space;
            EditorGUI.BeginChangeCheck();
            handle.DrawHandle();
            if (isFree)
                handle.Control = GUIUtility.hotControl;
            if (EditorGUI.EndChangeCheck())
            {
                Undo.RecordObject(box, "Change clip box");
                handle.Apply(box);
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

        /// <summary>A dragged side reports its total movement, in the space where the drag began.</summary>
        sealed class BoxHandle : BoxBoundsHandle
        {
            public int Control; // The control that was taken; 0 if none was.
            Vector3 m_scale;

            public Matrix4x4 Space { get; private set; }

            public bool IsDragged => Control != 0 && Control == GUIUtility.hotControl;

            public void Fit(Transform box)
            {
                (Space, m_scale) = (box.localToWorldMatrix, box.localScale);
                (center, size) = (Vector3.zero, Vector3.one);
            }

            public void Apply(Transform box)
            {
                var factors = size;
                for (int axis = 0; axis < 3; axis++)
                    factors[axis] = math.max(MinThickness, math.abs(factors[axis]));
                box.position = Space.MultiplyPoint3x4(center);
                box.localScale = Vector3.Scale(m_scale, factors);
            }
        }
    }
}
