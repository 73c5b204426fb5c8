using System.Globalization;
using FastPoints.Entities;
using FastPoints.Queries;
using FastPoints.Rendering;
using Unity.Mathematics;
using UnityEngine;

namespace FastPoints.Samples.AskAScan
{
    /// <summary>Asks the clouds of a scene through this camera. While the pointer moves: the height under it, and how many points
    /// lie around, at once, among the points that are in memory. By a click: the stored point there, with its attributes, and
    /// its distance from the one before.</summary>
    [RequireComponent(typeof(Camera))]
    [AddComponentMenu("FastPoints/Samples/Ask Scan")]
    public sealed class AskScan : MonoBehaviour
    {
        [Range(1, 20)]
        [Tooltip("How near the pointer has to be to a point.")]
        public float RadiusPx = 5;

        [Range(0.1f, 10)]
        [Tooltip("Of the sphere around the pointer in which points are counted, in metres.")]
        public float SphereMetres = 1;

        ScenePicker m_picker;
        StreamPick m_last;
        string m_picked = "Click a point.";
        string m_pointed = "";

        /// <summary>What is shown.</summary>
        public string Text => m_pointed + "\n" + m_picked;

        void OnEnable() => m_picker = new ScenePicker();

        void OnDisable() => m_picker.Dispose();

        void Update()
        {
            if (m_picker.IsSearching && m_picker.Update() && m_picker.Pick.Point != null)
                Show(m_picker.Pick);
        }

        // IMGUI's pointer works with either of Unity's input systems.
        void OnGUI()
        {
            var camera = GetComponent<Camera>();
            var pointer = Event.current.mousePosition;
            var ray = CameraViews.PickQueryOf(camera,
                camera.ScreenPointToRay(new Vector3(pointer.x, camera.pixelHeight - pointer.y, 0)), RadiusPx);
            if (Event.current.type == EventType.MouseDown && Event.current.button == 0)
                m_picker.Begin(ray);
            if (Event.current.type == EventType.Layout)
                m_pointed = Describe(PointCloudSystemGroup.ObjectQueries, ray);
            GUILayout.Label(Text);
        }

        string Describe(PointCloudQueries queries, PointQuery ray)
        {
            if (queries == null || !queries.Resident.TryFindFirst(ray, out var hit))
                return "No point under the pointer.";
            long around = queries.Resident.Count(PointQuery.Sphere(hit.PositionWorld, SphereMetres));
            string height = "Height " + Metres(hit.PositionWorld.y);
            // From a little above, so that the point itself is left out.
            var below = PointQuery.Below(hit.PositionWorld, 0.3);
            below.From = 2;
            if (queries.Resident.TryFindFirst(below, out var ground))
                height += ", " + Metres(hit.PositionWorld.y - ground.PositionWorld.y) + " over what lies below";
            return height + "\n" + around + " points within " + Metres(SphereMetres);
        }

        void Show(StreamPick pick)
        {
            m_picked = "";
            foreach (var attribute in pick.Point.Attributes)
                m_picked += attribute.Attribute.Name + "  " + attribute + "\n";
            var geo = pick.Point.PositionGeo;
            m_picked = Number(geo.x) + ", " + Number(geo.y) + ", " + Number(geo.z) + "\n" + m_picked;
            if (m_last != null)
                m_picked += "Distance from the one before: " + Metres(new Measurement(m_last, pick).WorldLength);
            m_last = pick;
        }

        static string Metres(double value) => Number(value) + " m";

        static string Number(double value) => value.ToString("0.00", CultureInfo.InvariantCulture);
    }
}
