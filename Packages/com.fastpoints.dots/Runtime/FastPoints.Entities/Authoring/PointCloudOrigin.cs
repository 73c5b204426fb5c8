using System;
using System.Collections.Generic;
using FastPoints.Streaming;
using Unity.Entities;
using Unity.Mathematics;
using UnityEngine;

namespace FastPoints.Entities
{
    /// <summary>The georeferenced place that lies at this GameObject, for all clouds beneath it: neighbouring tiles lie side by
    /// side, in double, and moving the origin moves all of them at once. Until it has a place, it takes that of the first cloud
    /// beneath it.</summary>
    [ExecuteAlways]
    [DisallowMultipleComponent]
    [AddComponentMenu("FastPoints/Point Cloud Origin")]
    [HelpPage("show")]
    [Icon("Packages/com.fastpoints.dots/Editor/Icons/PointCloudOrigin.png")]
    public sealed class PointCloudOrigin : MonoBehaviour
    {
        [SerializeField]
        [Tooltip("The place that lies at this GameObject: in the clouds' coordinates, X, Y and Z as their files have them.")]
        double3 m_place;

        [SerializeField]
        [HideInInspector]
        bool m_hasPlace;

        [SerializeField]
        [Tooltip("The coordinate system of that place. Clouds of another do not lie where they belong.")]
        string m_crs;

        [SerializeField]
        [HideInInspector]
        double m_scale = 1; // Metres of a unit; 0 for degrees, since scenes are text, which has no NaN.

        [SerializeField]
        [HideInInspector]
        double m_verticalScale;

        [SerializeField]
        [HideInInspector]
        UpAxis m_up = UpAxis.Z;

        static readonly List<PointCloud> s_found = new List<PointCloud>();
        readonly List<PointCloud> m_clouds = new List<PointCloud>();
        double3 m_shown;

        /// <summary>Called when a cloud has decided on a place or a coordinate system, where there is an editor.</summary>
        internal static Action<PointCloudOrigin> Decided { get; set; }

        /// <summary>Whether there is a place; otherwise the clouds stay at their own origins.</summary>
        public bool HasPosition => m_hasPlace;

        /// <summary>The place, georeferenced, in CRS units. Setting it moves all clouds at once.</summary>
        public double3 PositionGeo
        {
            get => m_place;
            set
            {
                m_place = value;
                m_hasPlace = true;
                Apply();
            }
        }

        /// <summary>Name of the coordinate system; empty if unknown.</summary>
        public string Crs => m_crs ?? "";

        /// <summary>Moves the origin to the middle of a cloud's floor, as a cloud without an origin lies.</summary>
        /// <returns>Whether it is known where the cloud lies.</returns>
        public bool AlignTo(PointCloud cloud)
        {
            if (cloud.Cloud != null && AlignTo(cloud.Cloud))
                return true;
            if (!cloud.TryGetSpace(out var space) || !cloud.TryGetLocalBounds(out var local))
                return false;
            var floor = new double3(local.center.x, local.center.y - local.size.y * 0.5, local.center.z);
            Set(math.round(space.ToGeo(floor)), space, "");
            return true;
        }

        /// <summary>Makes what lies at a position of the world now lie at this GameObject: all clouds move the other way, in
        /// double. With a floating origin, move everything else by the same, in the same frame.</summary>
        /// <param name="by">From this GameObject to that position, in the world's axes.</param>
        public void Shift(double3 by) =>
            PositionGeo = Space.ToGeo(math.mul(math.inverse(Linear(transform.localToWorldMatrix)), by));

        /// <summary>Does the same with all clouds of a world that have no GameObject, whatever their origins, and with those that
        /// come later, as of subscenes: they lie among the others.</summary>
        /// <param name="world">Null for the world that is shown.</param>
        public static void ShiftEntities(double3 by, World world = null)
        {
            var group = world == null ? PointCloudSystemGroup.ObjectGroup
                : world.IsCreated ? world.GetExistingSystemManaged<PointCloudSystemGroup>() : null;
            if (group != null)
                group.Shift += by;
        }

        internal bool AlignTo(PointCloudAsset asset)
        {
            bool isKnown = asset.TryGetSpace(out _, out var space);
            if (isKnown)
                Set(space.OriginGeo, space, asset.Crs ?? "");
            return isKnown;
        }

        internal void Add(PointCloud cloud) => m_clouds.Add(cloud);

        internal void Remove(PointCloud cloud) => m_clouds.Remove(cloud);

        internal void Compare(PointCloud cloud, string crs)
        {
            if (string.IsNullOrEmpty(crs))
                return;
            if (string.IsNullOrEmpty(m_crs))
            {
                m_crs = crs;
                Decided?.Invoke(this);
            }
            if (crs != m_crs)
                Debug.LogWarning("FastPoints: " + cloud.gameObject.name + " is in " + crs + ", but its " + gameObject.name +
                    " in " + m_crs + ": they do not lie as they should. Convert one of them, or give each an origin of its own");
        }

        void Update()
        {
            if (!m_hasPlace)
                UseFirst();
            // Undo, prefabs and animations change fields without notice.
            else if (!m_shown.Equals(m_place))
                Apply();
        }

        /// <summary>The first in the hierarchy decides, not the one that is opened first.</summary>
        void UseFirst()
        {
            if (m_clouds.Count == 0)
                return;
            GetComponentsInChildren(false, s_found);
            foreach (var cloud in s_found)
                if (AlignTo(cloud) || cloud.Error == null)
                    break;
            s_found.Clear();
        }

        UnityLocalSpace Space => new UnityLocalSpace
        {
            OriginGeo = m_place,
            Units = new CloudUnits(m_scale == 0 ? double.NaN : m_scale, m_verticalScale),
            Up = m_up,
        };

        void Set(double3 position, UnityLocalSpace space, string crs)
        {
            m_scale = space.Units.IsInDegrees ? 0 : space.Units.IsKnown ? space.Units.Horizontal : 1;
            (m_verticalScale, m_up, m_crs) = (space.Units.Vertical, space.Up, crs);
            PositionGeo = position;
            Decided?.Invoke(this);
        }

        void Apply()
        {
            m_shown = m_place;
            foreach (var cloud in m_clouds)
                cloud.PlaceByOrigin();
        }

        static double3x3 Linear(Matrix4x4 m) => new double3x3(new double3(m.m00, m.m10, m.m20), new double3(m.m01, m.m11, m.m21),
            new double3(m.m02, m.m12, m.m22));
    }
}
