using System.Collections.Generic;
using FastPoints.Entities;
using UnityEditor;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace FastPoints.Editor
{
    internal sealed class DropTarget
    {
        const string OriginName = "Point Cloud Origin";

        int m_sibling = -1;
        public Vector3? Point; // Where the pointer was; clouds with an origin lie by that instead.

        public Transform Parent;
        public Scene Scene; // The scene, if there is no parent; the default is the active one.

        /// <summary>The target of a drop in the Hierarchy.</summary>
        /// <param name="target">The GameObject that it fell on or beside; null for a scene, or nothing.</param>
        /// <param name="scene">The scene that it fell on, if it did.</param>
        public static DropTarget Of(GameObject target, HierarchyDropFlags flags, Transform parent, Scene scene)
        {
            var drop = new DropTarget { Parent = parent, Scene = target != null ? target.scene : scene };
            if (target == null || parent != null)
                return drop;
            var on = target.transform;
            if ((flags & HierarchyDropFlags.DropBetween) == 0)
            {
                drop.Parent = on;
                return drop;
            }
            drop.Parent = on.parent;
            drop.m_sibling = on.GetSiblingIndex() + ((flags & HierarchyDropFlags.DropAbove) != 0 ? 0 : 1);
            return drop;
        }

        /// <summary>Users may delete the target, or close its scene, before the files are imported.</summary>
        bool IsDestroyed => Parent is { } && Parent == null || Scene != default && !Scene.IsValid();

        /// <summary>Makes a GameObject for each cloud and selects what was made: a step of Undo with nothing else in it. Several
        /// share an origin, which is made if there is none.</summary>
        /// <returns>The last one; null if the target was destroyed.</returns>
        public GameObject AddToScene(IReadOnlyList<PointCloudAsset> assets)
        {
            if (IsDestroyed || assets.Count == 0)
                return null;
            // Changes some updates after the drop would join the user's last undo step, and the next step would join this.
            Undo.IncrementCurrentGroup();
            var origin = Parent != null ? Parent.GetComponentInParent<PointCloudOrigin>() : OfScene();
            if (assets.Count > 1 && origin == null)
                origin = ObjectFactory.AddComponent<PointCloudOrigin>(Create(OriginName, Parent, true));
            GameObject cloud = null;
            foreach (var asset in assets)
                cloud = AddToScene(asset, origin);
            Selection.activeObject = assets.Count > 1 ? origin.gameObject : cloud;
            Undo.IncrementCurrentGroup();
            return cloud;
        }

        GameObject AddToScene(PointCloudAsset asset, PointCloudOrigin origin)
        {
            var made = origin != null ? Create(asset.name, origin.transform, false) : Create(asset.name, Parent, true);
            if (Point.HasValue && origin == null)
                made.transform.position = Point.Value;
            // A closed subscene keeps only what is baked.
            if (made.scene.isSubScene)
                ObjectFactory.AddComponent<PointCloudAuthoring>(made).Cloud = asset;
            else
                ObjectFactory.AddComponent<PointCloud>(made).Cloud = asset;
            if (origin == null || origin.HasPosition)
                return made;
            Undo.RecordObject(origin, "Set origin");
            origin.AlignTo(asset);
            return made;
        }

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

        GameObject Create(string name, Transform parent, bool isOfDrop)
        {
            var made = ObjectFactory.CreateGameObject(name);
            // The Hierarchy's default parent keeps its world position: under another parent it would move.
            if (parent != null || Scene.IsValid())
                made.transform.SetParent(null, true);
            if (parent != null)
                made.transform.SetParent(parent, false);
            else if (Scene.IsValid() && made.scene != Scene)
                SceneManager.MoveGameObjectToScene(made, Scene);
            if (isOfDrop && m_sibling >= 0)
                made.transform.SetSiblingIndex(m_sibling++);
            return made;
        }
    }
}
