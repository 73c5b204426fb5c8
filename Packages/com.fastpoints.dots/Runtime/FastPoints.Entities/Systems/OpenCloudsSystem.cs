using System;
using System.Collections.Generic;
using System.Threading.Tasks;
using FastPoints.Picture;
using FastPoints.Rendering;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>Opens the folders of clouds that are there as files only: on threads of the pool, so that a slow disk stops
    /// nobody.</summary>
    [WorldSystemFilter(WorldSystemFilterFlags.Default | WorldSystemFilterFlags.Editor)]
    [UpdateInGroup(typeof(PointCloudSystemGroup), OrderFirst = true)]
    [UpdateBefore(typeof(AddCloudsSystem))]
    public partial class OpenCloudsSystem : StreamSystem
    {
        readonly Dictionary<Entity, Task<CloudFolder>> m_opening = new Dictionary<Entity, Task<CloudFolder>>();
        readonly List<Entity> m_opened = new List<Entity>();
        EntityQuery m_closed;

        protected override void OnCreate()
        {
            base.OnCreate();
            m_closed = new EntityQueryBuilder(Allocator.Temp).WithAll<PointCloudFile>().WithNone<PointCloudSource>().Build(this);
        }

        protected override void OnUpdate()
        {
            if (!m_closed.IsEmpty)
                Begin();
            if (m_opening.Count > 0)
                End();
        }

        protected override void OnDestroy()
        {
            foreach (var opening in m_opening.Values)
                opening.ContinueWith(t => t.Result.Dispose(), TaskContinuationOptions.OnlyOnRanToCompletion);
            m_opening.Clear();
            base.OnDestroy();
        }

        void Begin()
        {
            using (var entities = m_closed.ToEntityArray(Allocator.Temp))
                foreach (var entity in entities)
                {
                    var file = EntityManager.GetComponentObject<PointCloudFile>(entity);
                    if (file.Error != null || string.IsNullOrEmpty(file.Path) || m_opening.ContainsKey(entity))
                        continue;
                    string path = file.FullPath;
                    m_opening.Add(entity, Task.Run(() => CloudFolder.Open(path)));
                }
        }

        void End()
        {
            m_opened.Clear();
            foreach (var opening in m_opening)
                if (opening.Value.IsCompleted)
                    m_opened.Add(opening.Key);
            foreach (var entity in m_opened)
            {
                var opening = m_opening[entity];
                m_opening.Remove(entity);
                if (opening.IsFaulted)
                    Fail(entity, opening.Exception.InnerException);
                else if (!EntityManager.HasComponent<PointCloudFile>(entity))
                    opening.Result.Dispose();
                else
                    Add(entity, opening.Result, EntityManager.GetComponentObject<PointCloudFile>(entity));
            }
        }

        void Add(Entity entity, CloudFolder folder, PointCloudFile file)
        {
            var manifest = folder.Manifest;
            var space = UnitySpace.Of(manifest.BoundsGeo, manifest.MetresPerUnit);
            EntityManager.AddComponentData(entity, new PointCloudSpace { Value = space });
            EntityManager.AddComponentData(entity, new PointCloudPlacement());
            var ranges = DisplayRanges.Of(manifest);
            var mode = ranges.Resolve(file.Color);
            var source = new FolderSource(folder, CloudLooks.PlanesFor(mode, !file.HiddenClasses.IsEmpty));
            var colors = ColorMapping.Of(mode, ranges, manifest.Grid.FromCorner(manifest.Root.Corner));
            EntityManager.AddComponentData(entity, new PointCloudLook
            {
                Mode = mode,
                Gradient = file.Gradient,
                Value = CloudLooks.Of(colors, source, file.HiddenClasses),
            });
            EntityManager.AddComponentObject(entity, new PointCloudSource { Source = source });
        }

        void Fail(Entity entity, Exception failure)
        {
            if (!EntityManager.HasComponent<PointCloudFile>(entity))
                return;
            var file = EntityManager.GetComponentObject<PointCloudFile>(entity);
            file.Error = failure.Message;
            Group.Stream.Report(new StreamFailure(file.FullPath, -1, "cannot be opened: " + failure.Message));
        }
    }
}
