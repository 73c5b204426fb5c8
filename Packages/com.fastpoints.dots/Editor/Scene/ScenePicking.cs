using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Threading;
using FastPoints.Drawing;
using FastPoints.Entities;
using FastPoints.Queries;
using FastPoints.Rendering;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>Has a click in the Scene view select the cloud that has a point there: Unity asks, repeatedly for what
    /// is behind, where the click hits nothing that it draws itself.</summary>
    [InitializeOnLoad]
    internal static class ScenePicking
    {
        const double Radius = 5; // How far from the pointer a point may be, in points of the window.

        static StreamPicker s_picker;

        static ScenePicking()
        {
            if (!AssetDatabase.IsAssetImportWorkerProcess())
                HandleUtility.pickGameObjectCustomPasses += Pick;
        }

        /// <summary>Unity needs the answer at once: a click waits this long for files; then it hits what was found until
        /// then.</summary>
        internal static double MaxMs { get; set; } = 100;

        /// <param name="position">In pixels, from the lower left.</param>
        /// <param name="ignore">Null for none.</param>
        /// <param name="filter">The only ones; null for all.</param>
        internal static GameObject Pick(Camera camera, int layers, Vector2 position, GameObject[] ignore, GameObject[] filter,
            out int materialIndex)
        {
            materialIndex = 0;
            // The Scene view asks at each event of a drag, for whatever is dragged: nothing is dropped onto points.
            if (Event.current != null && (Event.current.type == EventType.DragUpdated ||
                Event.current.type == EventType.DragPerform))
                return null;
            var group = PointCloudSystemGroup.ObjectGroup;
            if (group?.Stream == null)
                return null;
            bool CanBePicked(GameObject cloud) => cloud != null && (layers & ~Tools.lockedLayers & 1 << cloud.layer) != 0 &&
                (ignore == null || Array.IndexOf(ignore, cloud) < 0) && (filter == null || Array.IndexOf(filter, cloud) >= 0) &&
                !SceneVisibilityManager.instance.IsPickingDisabled(cloud) &&
                StageUtility.IsGameObjectRenderedByCameraAndPartOfEditableScene(cloud, camera);
            var clouds = CloudsOf(group, CanBePicked);
            if (clouds.Count == 0)
                return null;
            if (s_picker == null)
            {
                s_picker = new StreamPicker();
                // One click asks several times; between clicks no file is kept open.
                EditorApplication.delayCall += DisposePicker;
            }
            var ray = CameraViews.PickQueryOf(camera, camera.ScreenPointToRay(position),
                Radius * EditorGUIUtility.pixelsPerPoint);
            s_picker.Begin(group.Stream, ray, cloud => clouds[cloud].Hidden, clouds.ContainsKey);
            var waited = Stopwatch.StartNew();
            while (!s_picker.Update(MaxMs) && waited.Elapsed.TotalMilliseconds < MaxMs)
                Thread.Yield();
            return s_picker.Pick.Point == null ? null : clouds[s_picker.Pick.Cloud].Object;
        }

        static void DisposePicker()
        {
            s_picker?.Dispose();
            s_picker = null;
        }

        /// <summary>GameObjects of clouds by the numbers that the stream has for their states, and classes that they
        /// hide.</summary>
        static Dictionary<int, (GameObject Object, ClassMask Hidden)> CloudsOf(PointCloudSystemGroup group,
            Predicate<GameObject> canBePicked)
        {
            var clouds = new Dictionary<int, (GameObject Object, ClassMask Hidden)>();
            var entities = group.World.EntityManager;
            foreach (var (entity, live) in group.Live)
            {
                if (live.Versions == null || !entities.HasComponent<PointCloudFile>(entity) || !canBePicked(live.Object))
                    continue;
                var hidden = entities.GetComponentData<PointCloudFile>(entity).HiddenClasses;
                foreach (int number in new[] { live.Versions.ShownNumber, live.Versions.Preview, live.Versions.Next })
                    clouds[number] = (live.Object, hidden);
            }
            return clouds;
        }
    }
}
