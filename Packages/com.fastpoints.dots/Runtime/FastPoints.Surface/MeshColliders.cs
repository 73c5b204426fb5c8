#if FASTPOINTS_PHYSICS
using System.Collections.Generic;
using FastPoints.Drawing;
using FastPoints.Streaming;
using Unity.Jobs;
using UnityEngine;
using UnityEngine.Rendering;

namespace FastPoints.Surface
{
    /// <summary>PhysX: mesh colliders below a cloud's GameObject, from a pool.</summary>
    internal sealed class MeshColliders : SurfaceColliders
    {
        readonly Transform m_parent;
        readonly Stack<(MeshCollider, Mesh)> m_free = new Stack<(MeshCollider, Mesh)>();
        readonly List<Object> m_owned = new List<Object>();

        public MeshColliders(in OpenedSurface opened, in SurfaceGrid grid, ClassMask hidden, in UnityLocalSpace space,
            Transform parent) : base(opened, grid, hidden, space) => m_parent = parent;

        public override void Dispose()
        {
            base.Dispose();
            foreach (var owned in m_owned)
                if (owned != null)
                    Object.Destroy(owned);
        }

        protected override void Hide(SurfaceCell cell) => Return((MeshCollider)cell.Collider, null);

        protected override void Move(SurfaceCell cell)
        {
            if ((MeshCollider)cell.Collider != null)
                ((MeshCollider)cell.Collider).transform.localPosition = PositionOf(cell);
        }

        protected override IEnumerator<JobStep> Show(SurfaceCell cell, PackedSurface surface)
        {
            var (collider, mesh) = Rent();
            var job = default(JobHandle);
            bool isShown = false;
            try
            {
                mesh.indexFormat = IndexFormat.UInt32;
                mesh.SetVertices(surface.Vertices);
                mesh.SetIndices(surface.Triangles.Reinterpret<int>(3 * sizeof(int)), MeshTopology.Triangles, 0);
#if UNITY_6000_3_OR_NEWER
                job = new BakeMeshJob { Mesh = mesh.GetEntityId() }.Schedule();
#else
                job = new BakeMeshJob { Mesh = mesh.GetInstanceID() }.Schedule();
#endif
                yield return job;
                collider.transform.localPosition = PositionOf(cell);
                collider.sharedMesh = mesh;
                collider.gameObject.layer = m_parent.gameObject.layer;
                collider.gameObject.SetActive(true);
                Replace(cell, collider);
                isShown = true;
            }
            finally
            {
                job.Complete();
                if (!isShown)
                    Return(collider, mesh);
            }
        }

        (MeshCollider, Mesh) Rent()
        {
            if (m_free.Count > 0)
                return m_free.Pop();
            var cell = new GameObject("Cell of a point cloud") { hideFlags = HideFlags.DontSave };
            var mesh = new Mesh { name = cell.name, hideFlags = HideFlags.DontSave };
            m_owned.AddRange(new Object[] { cell, mesh });
            cell.SetActive(false);
            cell.transform.SetParent(m_parent, false);
            return (cell.AddComponent<MeshCollider>(), mesh);
        }

        void Return(MeshCollider collider, Mesh mesh)
        {
            // Somebody may have deleted what lies below the cloud, or its mesh.
            if (collider == null)
                return;
            mesh ??= collider.sharedMesh;
            collider.gameObject.SetActive(false);
            collider.sharedMesh = null;
            if (mesh == null)
                return;
            mesh.Clear();
            m_free.Push((collider, mesh));
        }

        Vector3 PositionOf(SurfaceCell cell)
        {
            var at = LocalOf(cell.At);
            return new Vector3((float)at.x, (float)at.y, (float)at.z);
        }
    }

    /// <summary>Prepares a mesh for PhysX: some ten milliseconds that cannot be cut. Burst has nothing to compile here.</summary>
    internal struct BakeMeshJob : IJob
    {
#if UNITY_6000_3_OR_NEWER
        public EntityId Mesh;
#else
        public int Mesh;
#endif

        public void Execute() => Physics.BakeMesh(Mesh, false);
    }
}
#endif
