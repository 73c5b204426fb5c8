using System;
using FastPoints.Drawing;
using FastPoints.Queries;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Entities;
using Unity.Mathematics;

namespace FastPoints.Entities
{
    /// <summary>Picks points of all clouds that a world shows, as it shows them: it ignores points that are clipped or of a
    /// hidden class. Call <see cref="Begin"/>, then <see cref="Update"/> once a frame until it returns true. It works in players
    /// and in edit mode.</summary>
    public sealed class ScenePicker : IDisposable
    {
        readonly World m_world;
        readonly StreamPicker m_picker = new StreamPicker();

        /// <param name="world">Null for the default world.</param>
        public ScenePicker(World world = null) => m_world = world;

        /// <summary>Result of the search that was begun last; complete when that is done.</summary>
        public StreamPick Pick => m_picker.Pick;

        public bool IsSearching => m_picker.IsSearching;

        /// <summary>Begins a search of the clouds as they are now; a search in progress is cancelled.</summary>
        /// <param name="ray">See <see cref="Rendering.CameraViews.PickQueryOf"/>.</param>
        /// <returns>Whether there is a world that shows clouds.</returns>
        public bool Begin(PointQuery ray)
        {
            var group = Group;
            if (group?.Stream == null)
                return false;
            m_picker.Begin(group.Stream, ray, cloud => HiddenOf(cloud));
            return true;
        }

        /// <summary>Continues the search; call it once a frame.</summary>
        /// <param name="budgetMs">Time on the main thread.</param>
        /// <returns>Whether no search is in progress: <see cref="Pick"/> is then the result of the last one.</returns>
        public bool Update(double budgetMs = 1)
        {
            bool wasSearching = IsSearching, isDone = m_picker.Update(budgetMs);
            if (wasSearching && isDone && Pick.Point != null)
                ReadSettings(EntityOf(Pick.Cloud));
            return isDone;
        }

        /// <summary>The entity of a cloud's number in the stream; null if there is none.</summary>
        public Entity EntityOf(int cloud) => Group?.Live.EntityShowing(cloud) ?? Entity.Null;

        /// <summary>Where a picked point is now: its cloud may have been moved or reopened since.</summary>
        /// <param name="cloud">The cloud's entity when it was picked: see <see cref="EntityOf"/>.</param>
        /// <returns>The position in the world; if the cloud is no longer shown, where the point was picked.</returns>
        public double3 PositionOf(StreamPick pick, Entity cloud)
        {
            var shown = Group?.Stream == null ? null
                : NumberOf(cloud) is int number ? Group.Stream.Clouds[number] : FindStreamed(pick.Path);
            return shown == null ? pick.Point.PositionWorld : shown.Placement.OriginWorld + math.mul(shown.Placement.Linear,
                pick.Point.PositionGeo - shown.Source.Grid.ToGeo(shown.Source.Root.Corner));
        }

        public void Dispose() => m_picker.Dispose();

        PointCloudSystemGroup Group => m_world == null ? PointCloudSystemGroup.ObjectGroup
            : m_world.IsCreated ? m_world.GetExistingSystemManaged<PointCloudSystemGroup>() : null;

        void ReadSettings(Entity cloud)
        {
            if (cloud == Entity.Null)
                return;
            var entities = Group.World.EntityManager;
            if (!entities.HasComponent<PointCloudFile>(cloud))
                return;
            var file = entities.GetComponentData<PointCloudFile>(cloud);
            Pick.Up = file.Up;
            Pick.Units = file.Units(Pick.Units);
        }

        /// <summary>The cloud's number; null if the entity is gone.</summary>
        int? NumberOf(Entity cloud)
        {
            var entities = Group.World.EntityManager;
            return entities.Exists(cloud) && entities.HasComponent<PointCloudPlacement>(cloud) &&
                entities.HasComponent<StreamedPointCloud>(cloud)
                    ? entities.GetComponentData<StreamedPointCloud>(cloud).Number
                    : (int?)null;
        }

        StreamedCloud FindStreamed(string path)
        {
            foreach (var cloud in Group.Stream.Clouds)
                if (cloud != null && !cloud.IsRemoving && StoreFormat.FinishedPath(cloud.Source.Path) == path)
                    return cloud;
            return null;
        }

        ClassMask HiddenOf(int cloud)
        {
            var entity = EntityOf(cloud);
            var entities = Group.World.EntityManager;
            return entity != Entity.Null && entities.HasComponent<PointCloudLook>(entity)
                ? entities.GetComponentData<PointCloudLook>(entity).Value.HiddenClasses
                : default;
        }
    }
}
