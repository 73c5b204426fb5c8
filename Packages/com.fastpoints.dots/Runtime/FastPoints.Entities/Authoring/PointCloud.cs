using System;
using System.Collections.Generic;
using FastPoints.Drawing;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Entities;
using Unity.Mathematics;
using Unity.Transforms;
using UnityEngine;

namespace FastPoints.Entities
{
    /// <summary>A cloud in a scene of GameObjects: it makes the entity that streams the cloud at the GameObject's transform, in
    /// edit mode too.</summary>
    [ExecuteAlways]
    [DisallowMultipleComponent]
    [AddComponentMenu("FastPoints/Point Cloud")]
    [HelpPage("show")]
    [Icon("Packages/com.fastpoints.dots/Editor/Icons/PointCloud.png")]
    public sealed class PointCloud : MonoBehaviour
    {
        [SerializeField]
        [Tooltip("The cloud: what the editor makes of a file that is dropped into the project.")]
        PointCloudAsset m_cloud;

        [SerializeField]
        [Tooltip("Without a cloud above, the .fastpoints folder: absolute, below StreamingAssets, or a web server's " +
            "address. Where readers are loaded, any point cloud.")]
        string m_path;

        [SerializeField]
        [Tooltip("What points are coloured by; another where the cloud has nothing for it.")]
        ColorMode m_color = ColorMode.Auto;

        [SerializeField]
        [Tooltip("Of elevation and intensity.")]
        ColorRamp m_colorRamp = ColorRamp.Auto;

        [SerializeField]
        [Tooltip("Classes, 0 to 255, whose points are not drawn.")]
        int[] m_hiddenClasses = new int[0];

        [SerializeField]
        [Range(0, 1)]
        [Tooltip(LightTip)]
        float m_light;

        internal const string LightTip = "How much of the colours the scene's main and ambient light are applied to: 0 for " +
            "scanned colours, which have light in them, 0.7 for elevation and classes.";

        OwnedEntity m_entity;

        LocalToWorld m_placed;
        float m_lit;
        PointCloudLayer m_layer;
        string m_comparedCrs;

        PointCloudAsset m_openedCloud;
        string m_openedPath;
        ColorMode m_openedColor;
        ColorRamp m_openedColorRamp;
        ClassMask m_openedClasses;
        UpAxis m_openedUp;
        double m_openedMetresPerUnitOverride;

        /// <summary>The asset; null if <see cref="Path"/> names the cloud.</summary>
        public PointCloudAsset Cloud
        {
            get => m_cloud;
            set => Set(ref m_cloud, value);
        }

        /// <summary>Used if <see cref="Cloud"/> is null: the <c>.fastpoints</c> folder, absolute or below StreamingAssets, or
        /// its address on a web server. If readers are loaded (FastPoints.Import), it may be any point cloud: COPC, Potree and
        /// EPT are streamed directly, of others a preview is shown.</summary>
        public string Path
        {
            get => m_path;
            set => Set(ref m_path, value);
        }

        /// <summary>What points are coloured by; a cloud without these values chooses another mode.</summary>
        public ColorMode Color
        {
            get => m_color;
            set => Set(ref m_color, value);
        }

        /// <summary>The colours of elevation and intensity.</summary>
        public ColorRamp ColorRamp
        {
            get => m_colorRamp;
            set => Set(ref m_colorRamp, value);
        }

        /// <summary>Classes from 0 to 255 whose points are not drawn. The array is a copy.</summary>
        public int[] HiddenClasses
        {
            get => (int[])m_hiddenClasses.Clone();
            set
            {
                m_hiddenClasses = (int[])value.Clone();
                Reopen();
            }
        }

        /// <summary>How much of the colours is lit by the scene, from 0 to 1.</summary>
        public float Light
        {
            get => m_light;
            set => m_light = value;
        }

        /// <summary>Whether the eye in the hierarchy hides a GameObject from scene views, where there is an editor.</summary>
        internal static Func<GameObject, bool> IsHiddenInSceneViews { get; set; }

        /// <summary>Null while the component is disabled.</summary>
        public Entity Entity => m_entity.Value;

        /// <summary>The nearest <see cref="PointCloudOrigin"/> among its parents, which positions it; null if there is none. Not
        /// serialized: script reloads would keep it.</summary>
        [field: NonSerialized]
        internal PointCloudOrigin Origin { get; private set; }

        /// <summary>The error of opening the cloud, in one line; null if there was none.</summary>
        public string Error => TryGet(out var entities) ? GroupOf(entities)?.ErrorOf(Entity) : null;

        /// <summary>The space in which the cloud is shown and that the transform moves.</summary>
        public bool TryGetSpace(out UnityLocalSpace space)
        {
            bool exists = TryGet(out var entities) && entities.HasComponent<PointCloudSpace>(Entity);
            space = exists ? entities.GetComponentData<PointCloudSpace>(Entity).Value : default;
            return exists;
        }

        /// <summary>Its number in the stream, as hits of queries and PointCloudBuffers have it; -1 while it is not
        /// shown.</summary>
        public int Number => TryGet(out var entities) && entities.HasComponent<StreamedPointCloud>(Entity)
            ? entities.GetComponentData<StreamedPointCloud>(Entity).Number : -1;

        /// <summary>Opens newer data on disk. The shown cloud stays until they are ready.</summary>
        public void Refresh()
        {
            if (!TryGet(out var entities))
            {
                Reopen();
                return;
            }
            var file = entities.GetComponentData<PointCloudFile>(Entity);
            file.NeedsRefresh = true;
            entities.SetComponentData(Entity, file);
        }

        /// <summary>Opens the cloud again from scratch: it may have to stream other planes.</summary>
        public void Reopen()
        {
            if (!isActiveAndEnabled)
                return;
            m_entity.Destroy();
            Add();
        }

        /// <summary>The box around the cloud, in the component's own space and Unity's units.</summary>
        /// <returns>Whether it is known, from the streamed cloud or from its asset.</returns>
        public bool TryGetLocalBounds(out Bounds local) =>
            (TryGet(out var entities) && CloudBounds.TryGet(entities, Entity, out local)) ||
            CloudBounds.TryGet(m_cloud, out local);

        /// <summary>The box along the world's axes around the cloud at its current place.</summary>
        /// <returns>See <see cref="TryGetLocalBounds"/>.</returns>
        public bool TryGetWorldBounds(out Bounds world)
        {
            bool isKnown = TryGetLocalBounds(out var local);
            world = isKnown ? CloudBounds.Transform(transform.localToWorldMatrix, local) : default;
            return isKnown;
        }

        void OnEnable()
        {
            FindOrigin();
            Add();
        }

        void OnDisable()
        {
            m_entity.Destroy();
            SetOrigin(null);
        }

        void Update()
        {
            // Undo, prefabs and animations change fields and parents without notice; others may end the entity or its world.
            if (FindOrigin() || !IsUnchanged || HasCloud && !TryGet(out _))
                Reopen();
            if (Origin != null && m_cloud != null && !ReferenceEquals(m_comparedCrs, m_cloud.Crs))
                Origin.Compare(this, m_comparedCrs = m_cloud.Crs);
            if (!TryGet(out var entities))
                return;
            AssignOwner(entities);
            SetLight(entities);
            var layer = Layer;
            if (layer.IsSame(m_layer))
                return;
            m_layer = layer;
            entities.SetComponentData(Entity, layer);
        }

        void SetLight(EntityManager entities)
        {
            if (m_lit == m_light)
                return;
            var file = entities.GetComponentData<PointCloudFile>(Entity);
            file.Light = m_lit = m_light;
            entities.SetComponentData(Entity, file);
        }

        // Animations, timelines and scripts move what meshes follow after Update.
        void LateUpdate()
        {
            if (TryGet(out var entities))
                TransformMatrix.Set(entities, Entity, transform, ref m_placed);
        }

        /// <summary>A destroyed entity keeps its cleanup components for a while, but no component to write
        /// to.</summary>
        bool TryGet(out EntityManager entities) =>
            m_entity.TryGet(out entities) && entities.HasComponent<PointCloudFile>(Entity);

        static PointCloudSystemGroup GroupOf(EntityManager entities) =>
            entities.World.GetExistingSystemManaged<PointCloudSystemGroup>();

        /// <summary>Not a component: a copy of the entity has no owner.</summary>
        void AssignOwner(EntityManager entities)
        {
            var group = GroupOf(entities);
            if (group != null)
                group.Live.GetOrAdd(Entity).Object = gameObject;
        }

        PointCloudFile File => m_cloud != null ? m_cloud.File() : new PointCloudFile();
        PointCloudPaths Paths => m_cloud != null ? m_cloud.Paths : new PointCloudPaths { Path = m_path };
        internal string FullPath => Paths.FullPath;

        /// <summary>The space in which the cloud is shown, or will be: also where nothing draws it, as on a server.</summary>
        internal UnityLocalSpace SpaceOf(CloudManifest manifest)
        {
            var file = File;
            Place(ref file);
            return TryGetSpace(out var space) ? space : file.SpaceOf(manifest.BoundsGeo, manifest.Crs.Units);
        }

        PointCloudLayer Layer => new PointCloudLayer
        {
            Value = gameObject.layer,
            Scenes = gameObject.sceneCullingMask,
            IsHiddenInSceneViews = IsHiddenInSceneViews != null && IsHiddenInSceneViews(gameObject),
        };

        void OnDrawGizmosSelected()
        {
            if (!TryGetLocalBounds(out var local))
                return;
            Gizmos.matrix = transform.localToWorldMatrix;
            Gizmos.DrawWireCube(local.center, local.size);
        }

        internal void PlaceByOrigin()
        {
            if (!TryGet(out var entities))
                return;
            var file = entities.GetComponentData<PointCloudFile>(Entity);
            Place(ref file);
            entities.SetComponentData(Entity, file);
        }

        void Place(ref PointCloudFile file)
        {
            if (Origin == null || !Origin.HasPosition)
                return;
            file.HasOrigin = true;
            file.OriginGeo = Origin.PositionGeo;
        }

        /// <returns>Whether it is another than before.</returns>
        bool FindOrigin()
        {
            var origin = GetComponentInParent<PointCloudOrigin>();
            if (origin != null && !origin.isActiveAndEnabled)
                origin = null;
            return SetOrigin(origin);
        }

        bool SetOrigin(PointCloudOrigin origin)
        {
            if (ReferenceEquals(origin, Origin))
                return false;
            if (!(Origin is null))
                Origin.Remove(this);
            if (!(origin is null))
                origin.Add(this);
            Origin = origin;
            m_comparedCrs = null;
            return true;
        }

        bool IsUnchanged => m_openedCloud == m_cloud && m_openedPath == (m_path ?? "") &&
            m_openedColor == m_color && m_openedColorRamp == m_colorRamp &&
            m_openedClasses.Equals(ClassMask.Of(m_hiddenClasses)) &&
            (m_cloud == null || m_openedUp == m_cloud.Up && m_openedMetresPerUnitOverride == m_cloud.MetresPerUnitOverride);

        internal bool HasCloud => m_cloud != null || !string.IsNullOrEmpty(m_path);

        void Set<T>(ref T field, T value)
        {
            if (EqualityComparer<T>.Default.Equals(field, value))
                return;
            field = value;
            Reopen();
        }

        void Add()
        {
            (m_openedCloud, m_openedPath, m_openedColor, m_openedColorRamp) = (m_cloud, m_path ?? "", m_color, m_colorRamp);
            m_openedClasses = ClassMask.Of(m_hiddenClasses);
            if (m_cloud != null)
                (m_openedUp, m_openedMetresPerUnitOverride) = (m_cloud.Up, m_cloud.MetresPerUnitOverride);
            if (!HasCloud || !m_entity.TryCreate(out var entities))
                return;
            entities.AddComponentData(Entity, m_placed = TransformMatrix.Of(transform));
            entities.AddComponentData(Entity, m_layer = Layer);
            var file = File;
            file.Color = m_color;
            file.ColorRamp = m_colorRamp;
            file.HiddenClasses = m_openedClasses;
            file.Light = m_lit = m_light;
            Place(ref file);
            entities.AddComponentData(Entity, file);
            Paths.WriteTo(entities.AddBuffer<PointCloudPathByte>(Entity));
            AssignOwner(entities);
        }
    }

    static class TransformMatrix
    {
        /// <summary>Updates the entity's transform. One that does not move is not written to: that would complete others' jobs,
        /// and tell them of a change.</summary>
        /// <param name="placed">As it was written last.</param>
        public static void Set(EntityManager entities, Entity entity, Transform transform, ref LocalToWorld placed)
        {
            var now = Of(transform);
            if (!now.Value.Equals(placed.Value))
                entities.SetComponentData(entity, placed = now);
        }

        public static LocalToWorld Of(Transform transform)
        {
            var matrix = transform.localToWorldMatrix;
            return new LocalToWorld
            {
                Value = new float4x4(
                    new float4(matrix.m00, matrix.m10, matrix.m20, matrix.m30),
                    new float4(matrix.m01, matrix.m11, matrix.m21, matrix.m31),
                    new float4(matrix.m02, matrix.m12, matrix.m22, matrix.m32),
                    new float4(matrix.m03, matrix.m13, matrix.m23, matrix.m33)),
            };
        }
    }
}
