using FastPoints.Entities;
using UnityEditor;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace FastPoints.Editor
{
    /// <summary>Where in a scene clouds are dropped: a point, a parent, a scene, a place among siblings; and the origin that
    /// several of them share.</summary>
    internal sealed class DropPlace
    {
        const string OriginName = "Point Cloud Origin";

        int m_sibling = -1;
        int m_undoGroup = -1;
        bool m_isShared;
        PointCloudOrigin m_origin;

        /// <summary>Where the pointer was; clouds with an origin lie by that instead.</summary>
        public Vector3? Point;

        public Transform Parent;

        /// <summary>The scene, if there is no parent; the default is the active one.</summary>
        public Scene Scene;

        /// <summary>The place of a drop in the Hierarchy.</summary>
        /// <param name="target">The GameObject that it fell on or beside; null for a scene, or nothing.</param>
        /// <param name="scene">The scene that it fell on, if it did.</param>
        public static DropPlace Of(GameObject target, HierarchyDropFlags flags, Transform parent, Scene scene)
        {
            var place = new DropPlace { Parent = parent, Scene = target != null ? target.scene : scene };
            if (target == null || parent != null)
                return place;
            var on = target.transform;
            if ((flags & HierarchyDropFlags.DropBetween) == 0)
            {
                place.Parent = on;
                return place;
            }
            place.Parent = on.parent;
            place.m_sibling = on.GetSiblingIndex() + ((flags & HierarchyDropFlags.DropAbove) != 0 ? 0 : 1);
            return place;
        }

        /// <summary>Several clouds come: they share an origin, which is made if there is none.</summary>
        public void Share() => m_isShared = true;

        /// <summary>Makes a GameObject for a cloud; Undo takes away all that one drop has made.</summary>
        public PointCloud Show(PointCloudAsset asset)
        {
            if (m_undoGroup < 0)
                Begin();
            var made = m_origin != null ? Make(asset.name, m_origin.transform, false) : Make(asset.name, Parent, true);
            if (Point.HasValue && m_origin == null)
                made.transform.position = Point.Value;
            var cloud = ObjectFactory.AddComponent<PointCloud>(made);
            cloud.Cloud = asset;
            if (m_origin != null && !m_origin.HasPlace)
                m_origin.AlignTo(asset);
            // The user may have deleted it since the last one.
            Selection.activeObject = m_isShared && m_origin != null ? m_origin.gameObject : made;
            Undo.CollapseUndoOperations(m_undoGroup);
            return cloud;
        }

        void Begin()
        {
            m_undoGroup = Undo.GetCurrentGroup();
            m_origin = Parent != null ? Parent.GetComponentInParent<PointCloudOrigin>() : OfScene();
            if (m_isShared && m_origin == null)
                m_origin = ObjectFactory.AddComponent<PointCloudOrigin>(Make(OriginName, Parent, true));
        }

        /// <summary>The scene's only origin.</summary>
        PointCloudOrigin OfScene()
        {
            var scene = Scene.IsValid() ? Scene : SceneManager.GetActiveScene();
            PointCloudOrigin only = null;
            foreach (var origin in Resources.FindObjectsOfTypeAll<PointCloudOrigin>())
            {
                if (!origin.isActiveAndEnabled || origin.gameObject.scene != scene)
                    continue;
                if (only != null)
                    return null;
                only = origin;
            }
            return only;
        }

        GameObject Make(string name, Transform parent, bool isOfDrop)
        {
            var made = ObjectFactory.CreateGameObject(name);
            if (parent != null)
            {
                made.transform.SetParent(parent, false);
            }
            else if (Scene.IsValid() && made.scene != Scene)
            {
                made.transform.SetParent(null, false);
                SceneManager.MoveGameObjectToScene(made, Scene);
            }
            if (isOfDrop && m_sibling >= 0)
                made.transform.SetSiblingIndex(m_sibling++);
            return made;
        }
    }
}
