#if FASTPOINTS_PHYSICS
using System.Collections.Generic;
using FastPoints.Drawing;
using FastPoints.Entities;
using Unity.Mathematics;
using UnityEngine;

namespace FastPoints.Surface
{
    /// <summary>Ground and walls of a converted cloud for physics, near what moves: while the game plays, surfaces of its points
    /// are made cell by cell in jobs, the nearest first, and become mesh colliders below this GameObject. They are thin sheets
    /// that hold from both sides, as high as the points; where the scan has nothing, there is no ground.</summary>
    [DisallowMultipleComponent, RequireComponent(typeof(PointCloud))]
    [AddComponentMenu("FastPoints/Point Cloud Collider")]
    [HelpPage("colliders")]
    [Icon("Packages/com.fastpoints.dots/Editor/Icons/PointCloud.png")]
    public sealed class PointCloudCollider : MonoBehaviour
    {
        [Tooltip("What moves: players, vehicles, agents. There are colliders around each of them, and nowhere else.")]
        public List<Transform> Followed = new List<Transform>();

        [Range(1, 100)]
        [Tooltip("How far from what moves there are colliders, in world units; at most 8 cells of 80 voxels.")]
        public float Radius = 10;

        [Range(0.01f, 5)]
        [Tooltip("Edge of a voxel in metres of the cloud: the size of triangles, and how far points of a surface may be apart.")]
        public float VoxelSize = 0.1f;

        [Range(0, 40)]
        [Tooltip("The widest holes that are closed, in metres of the cloud; at most 8 voxels.")]
        public float HoleSize = 0.3f;

        [Tooltip("Classes, 0 to 255, that are left out: cars, people, plants.")]
        public int[] HiddenClasses = new int[0];

        [Tooltip("The most cells that are kept, empty ones too.")]
        public int MaxCells = 256;

        [Tooltip("The most triangles that are kept: those of the nearest cells, whatever the radius is.")]
        public int MaxTriangles = 1_000_000;

        [Range(0.1f, 4)]
        [Tooltip("Time of the main thread in each frame while cells are made, in ms, beside what PhysX takes.")]
        public float FrameMs = 0.5f;

        [Tooltip("Of the surfaces of cells that are kept on disk, beside the cloud, so that they are made once; 0 for none.")]
        public int CacheMegabytes = 256;

        readonly List<double3> m_near = new List<double3>();
        SurfaceUpdates m_updates;
        PointCloud m_cloud;
        PointCloudAsset m_openedCloud;
        string m_openedPath;

        internal SurfaceColliders Surface => m_updates?.Surface;

        /// <summary>What went wrong last, in one line; null if all is well. It is tried again every five seconds.</summary>
        public string Error => m_updates?.Error;

        /// <summary>Cells that are kept, empty ones too.</summary>
        public int CellCount => Surface == null ? 0 : Surface.Cells.Made.Count;
        public long TriangleCount => Surface == null ? 0 : Surface.Cells.Triangles;

        /// <summary>Another number whenever a collider was added, changed or removed.</summary>
        public int Version => m_updates == null ? 0 : m_updates.Version;

        /// <summary>Whether the cells around a position of the world are made, with ground in them or without: hold players until
        /// then, after a start or a jump. Never where nothing that is followed is near.</summary>
        /// <param name="reach">How far around, in world units.</param>
        public bool IsReady(Vector3 position, float reach = 2) => Surface != null && Surface.IsReady(Of(position), reach);

        /// <summary>Makes all anew, for example after the cloud was converted again.</summary>
        public void Reopen() => m_updates?.Reopen();

#if FASTPOINTS_AI
        /// <summary>Adds the colliders of now as sources of a navigation mesh: build it anew when <see cref="Version"/>
        /// changes.</summary>
        public void AddNavMeshSources(List<UnityEngine.AI.NavMeshBuildSource> sources)
        {
            for (int i = 0; i < CellCount; i++)
                if (Surface.Cells.Made[i].Collider is MeshCollider collider && collider != null)
                    sources.Add(new UnityEngine.AI.NavMeshBuildSource
                    {
                        shape = UnityEngine.AI.NavMeshBuildSourceShape.Mesh,
                        sourceObject = collider.sharedMesh,
                        transform = collider.transform.localToWorldMatrix,
                        component = collider,
                    });
        }
#endif

        void OnEnable()
        {
            m_cloud = GetComponent<PointCloud>();
            m_updates ??= new SurfaceUpdates(() => m_cloud.HasCloud ? m_cloud.FullPath : null, Make, Follow);
        }

        void OnDisable() => Reopen();

        // What it follows has moved by then.
        internal void LateUpdate()
        {
            if (m_openedCloud != m_cloud.Cloud || m_openedPath != m_cloud.Path)
                Reopen();
            (m_openedCloud, m_openedPath) = (m_cloud.Cloud, m_cloud.Path);
            m_updates.Update(name, CacheMegabytes, FrameMs);
        }

        SurfaceColliders Make(OpenedSurface opened) => new MeshColliders(opened, Grid, ClassMask.Of(HiddenClasses),
            m_cloud.SpaceOf(opened.Folder.Manifest), transform);

        bool Follow(SurfaceColliders surface)
        {
            var space = m_cloud.SpaceOf(surface.Manifest);
            if (!surface.IsMadeBy(Grid, ClassMask.Of(HiddenClasses), space))
                return false;
            (surface.Cells.MaxCells, surface.Cells.MaxTriangles) = (MaxCells, MaxTriangles);
            m_near.Clear();
            foreach (var followed in Followed)
                if (followed != null)
                    m_near.Add(Of(followed.position));
            surface.Follow(space, new double4x4(TransformMatrix.Of(transform).Value), m_near, Radius);
            return true;
        }

        SurfaceGrid Grid => SurfaceColliders.GridOf(VoxelSize, HoleSize);
        static double3 Of(Vector3 v) => new double3(v.x, v.y, v.z);
    }
}
#endif
