using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Drawing;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Entities;
using Unity.Mathematics;
using Unity.Transforms;

namespace FastPoints.Entities
{
    /// <summary>Opens clouds that only exist as files, and brings each of their states into the stream: waves of a preview,
    /// generations of a build, the finished cloud. Files that change are opened again, or placed elsewhere.</summary>
    [WorldSystemFilter(WorldSystemFilterFlags.Default | WorldSystemFilterFlags.Editor)]
    [UpdateInGroup(typeof(PointCloudSystemGroup), OrderFirst = true)]
    [UpdateBefore(typeof(AddCloudsSystem))]
    internal partial class OpenCloudsSystem : StreamSystem
    {
        const double BudgetMs = 2; // Main-thread time in each frame for all previews together.

        readonly List<OpenedCloud> m_removing = new List<OpenedCloud>();
        EntityQuery m_files;

        protected override void OnCreate()
        {
            base.OnCreate();
            m_files = GetEntityQuery(ComponentType.ReadOnly<PointCloudFile>(), ComponentType.ReadOnly<PointCloudPathByte>());
        }

        protected override void OnUpdate()
        {
            Group.IsOpening = Group.IsFollowing = false;
            if (!m_files.IsEmpty)
                Begin();
            UpdateOpened();
            for (int i = m_removing.Count - 1; i >= 0; i--)
            {
                if (!m_removing[i].IsOpen)
                    continue;
                m_removing[i].Dispose();
                m_removing.RemoveAt(i);
            }
        }

        protected override void OnDestroy()
        {
            foreach (var removing in m_removing)
                removing.Dispose();
            m_removing.Clear();
            base.OnDestroy();
        }

        void Begin()
        {
            using var entities = m_files.ToEntityArray(Allocator.Temp);
            foreach (var entity in entities)
            {
                var file = EntityManager.GetComponentData<PointCloudFile>(entity);
                var paths = PointCloudPaths.BytesOf(EntityManager.GetBuffer<PointCloudPathByte>(entity, true));
                var live = Group.Live.GetOrAdd(entity);
                bool isOpened = live.Opened != null, isSame = isOpened && live.Opened.Matches(file, paths);
                if (isSame && (live.Error == null || !file.NeedsRefresh))
                {
                    Move(entity, file, live.Opened);
                    continue;
                }
                if (isOpened)
                    End(entity, live, !isSame);
                if (isOpened && !isSame)
                {
                    // The shown cloud is removed in this frame; the next frame opens the other.
                    live.Error = null;
                    continue;
                }
                bool isNew = live.Error == null && live.NextSource == null && live.Versions == null;
                if (paths.Length == 0 || paths[0] == 0 || !isOpened && !isNew && !file.NeedsRefresh)
                    continue;
                live.Error = null;
                if (!TryOpen(live, file, paths))
                    continue;
                if (file.NeedsRefresh)
                    ClearRefresh(entity, file);
                Move(entity, file, live.Opened);
            }
        }

        /// <summary>On Windows, older run times refuse paths with quotes and the like.</summary>
        bool TryOpen(EntityCloud live, in PointCloudFile file, ReadOnlySpan<byte> paths)
        {
            try
            {
                live.Opened = new OpenedCloud(file, paths);
                return true;
            }
            catch (Exception e) when (e is ArgumentException || e is NotSupportedException || e is PathTooLongException)
            {
                string path = SourcePath.WithoutQuery(PointCloudPaths.Of(paths).Path);
                live.Error = path + ": " + e.Message;
                Group.Stream.Report(new StreamFailure(path, -1, "cannot be opened: " + e.Message));
                return false;
            }
        }

        /// <param name="hides">Whether the shown cloud is removed.</param>
        void End(Entity entity, EntityCloud live, bool hides)
        {
            m_removing.Add(live.Opened);
            live.Opened = null;
            if (!hides)
                return;
            live.DropSource();
            // Without a placement it leaves the stream.
            EntityManager.RemoveComponent<PointCloudPlacement>(entity);
            EntityManager.RemoveComponent<PointCloudSpace>(entity);
            EntityManager.RemoveComponent<PointCloudLook>(entity);
        }

        void ClearRefresh(Entity entity, PointCloudFile file)
        {
            file.NeedsRefresh = false;
            EntityManager.SetComponentData(entity, file);
        }

        void Move(Entity entity, in PointCloudFile file, OpenedCloud opened)
        {
            double3 local = default;
            if (!opened.WorldShift.Equals(Group.Shift) && Group.Live.GetOrAdd(entity).Object == null &&
                EntityManager.HasComponent<LocalToWorld>(entity))
            {
                var toWorld = new double4x4(EntityManager.GetComponentData<LocalToWorld>(entity).Value);
                var linear = new double3x3(toWorld.c0.xyz, toWorld.c1.xyz, toWorld.c2.xyz);
                // A singular matrix is a transform that is not set yet.
                if (math.determinant(linear) != 0)
                {
                    local = math.mul(math.inverse(linear), Group.Shift - opened.WorldShift);
                    opened.Shift += local;
                    opened.WorldShift = Group.Shift;
                }
            }
            bool isElsewhere = file.HasOrigin &&
                !(opened.AppliedFile.HasOrigin && opened.AppliedFile.OriginGeo.Equals(file.OriginGeo));
            (opened.AppliedFile.HasOrigin, opened.AppliedFile.OriginGeo) = (file.HasOrigin, file.OriginGeo);
            if (!isElsewhere && local.Equals(default) || !EntityManager.HasComponent<PointCloudSpace>(entity))
                return;
            var space = EntityManager.GetComponentData<PointCloudSpace>(entity);
            if (isElsewhere)
                (space.Value.OriginGeo, local) = (file.OriginGeo, opened.Shift);
            space.Value.OriginGeo = space.Value.ToGeo(local);
            EntityManager.SetComponentData(entity, space);
        }

        void UpdateOpened()
        {
            int count = 0;
            foreach (var (_, live) in Group.Live)
                count += live.Opened != null ? 1 : 0;
            foreach (var (entity, live) in Group.Live)
                if (live.Opened != null && EntityManager.HasComponent<PointCloudFile>(entity) &&
                    !EntityManager.HasComponent<Prefab>(entity))
                    Update(entity, live, BudgetMs / count);
                else if (live.Opened != null)
                    End(entity, live, false);
        }

        void Update(Entity entity, EntityCloud live, double budgetMs)
        {
            var file = EntityManager.GetComponentData<PointCloudFile>(entity);
            var opened = live.Opened;
            try
            {
                if (file.NeedsRefresh)
                {
                    opened.Refresh();
                    ClearRefresh(entity, file);
                }
                opened.Update(budgetMs);
                if (opened.Newest != null)
                {
                    Group.Wake();
                    Take(entity, live, file);
                }
                if (opened.IsBuildAborted)
                    live.Versions?.DropBuild();
                Group.IsOpening |= !opened.IsIdle;
                Group.IsFollowing |= opened.IsFollowed;
            }
            catch (Exception e)
            {
                // Any exception ends this cloud, but not the update of the others.
                var failure = PointCloudException.Of(opened.Path, e);
                live.Error = failure.Message;
                Group.Stream.Report(new StreamFailure(opened.Path, -1, "cannot be opened: " + failure.FullMessage));
                opened.Dispose();
            }
        }

        /// <summary>Takes one state after the other, each when the previous one is shown.</summary>
        void Take(Entity entity, EntityCloud live, in PointCloudFile file)
        {
            if (live.NextSource != null || live.Versions != null && !live.Versions.IsCurrent)
                return;
            var facts = live.Opened.Newest;
            var taken = live.Opened.Take(file);
            live.SetSource(taken.Source, taken.Look, taken.Stage);
            if (live.Versions == null)
                Place(entity, facts, file, live.Opened.Shift);
        }

        /// <summary>Places all states where the first one stood, so that nothing moves when it is replaced.</summary>
        void Place(Entity entity, CloudFacts facts, in PointCloudFile file, double3 shift)
        {
            var space = file.SpaceOf(facts.BoundsGeo, facts.Units);
            space.OriginGeo = space.ToGeo(shift);
            EntityManager.AddComponentData(entity, new PointCloudSpace { Value = space });
            EntityManager.AddComponentData(entity, new PointCloudPlacement());
        }
    }
}
