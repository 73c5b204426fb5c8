using System;
using System.Collections.Generic;
using FastPoints.Entities;
using FastPoints.Queries;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Entities;
using Unity.Mathematics;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>Makes operations of strokes over points and of boxes. A stroke picks point after point along the pointer's way,
    /// all of the cloud that it began on, and becomes one operation when it ends. Until then its points are shown classified or
    /// coloured; those to delete or hide marked, since the pointer would pick what lies behind them.</summary>
    internal sealed class EditSession : IDisposable
    {
        const double DraftSeconds = 0.1;

        static readonly byte[] s_mark = { 255, 128, 0 };

        readonly ScenePicker m_picker = new ScenePicker();
        readonly List<StreamPick> m_stroke = new List<StreamPick>();
        Entity m_entity; // Of the stroke.
        string m_journal; // Of its cloud.
        ulong m_cloudId; // Its grid positions are of this conversion.
        EditOperation m_draft; // What is shown of it; null if nothing can be.
        int m_draftLength;
        double m_nextDraft; // Not before: the picker opens each state anew.
        PointQuery m_next;
        bool m_hasNext;
        bool m_isEnding;

        public EditAction Action { get; set; } = EditAction.Delete;
        public byte Class { get; set; }
        public Color Color { get; set; } = new Color(1, 0, 0, 1);

        public float Radius { get; set; } = 0.5f; // Of the brush, in world units.

        public IReadOnlyList<StreamPick> Stroke => m_stroke;

        public List<PointQuery> Lasso { get; } = new List<PointQuery>(); // The rays through its corners, all of one camera.

        public string Note { get; private set; } // What is amiss; null if nothing is.

        public void Drag(PointQuery ray)
        {
            (m_next, m_hasNext) = (ray, true);
            BeginNext();
        }

        public void EndStroke() => m_isEnding = true;

        public void ClearStroke()
        {
            if (m_draft != null)
                EditJournal.SetDraft(null, null);
            m_stroke.Clear();
            (m_hasNext, m_isEnding, m_draft, m_draftLength) = (false, false, null, 0);
        }

        /// <summary>Goes on with picking; called once an update of the editor.</summary>
        /// <returns>Whether there is something new to be drawn.</returns>
        public bool Update(double budgetMs)
        {
            bool isNew = m_picker.IsSearching && m_picker.Update(budgetMs) && AddToStroke(m_picker.Pick);
            BeginNext();
            if (m_stroke.Count > 0)
                ShowStroke();
            if (!m_isEnding || m_hasNext || m_picker.IsSearching)
                return isNew;
            var shown = m_stroke.Count > 0 ? FindShown() : null;
            if (m_stroke.Count > 0 && CanEdit(shown) && Begin(shown, AddStroke(shown, NewOperation(m_cloudId))))
                m_draft = null; // It is shown until it is written.
            ClearStroke();
            return true;
        }

        /// <param name="local">In the space of the cloud's GameObject.</param>
        public void ApplyBox(PointCloud cloud, Bounds local)
        {
            var shown = SceneExport.FindStreamed(cloud, out _);
            if (!CanEdit(shown))
                return;
            double3 min = double.PositiveInfinity, max = double.NegativeInfinity;
            for (int corner = 0; corner < 8; corner++)
            {
                var sign = new Vector3((corner & 1) * 2 - 1, (corner & 2) - 1, (corner & 4) / 2 - 1);
                var world = cloud.transform.localToWorldMatrix.MultiplyPoint3x4(
                    local.center + Vector3.Scale(local.size * 0.5f, sign));
                var geo = GeoOf(shown, new double3(world.x, world.y, world.z));
                (min, max) = (math.min(min, geo), math.max(max, geo));
            }
            var operation = NewOperation(IdOf(shown));
            operation.Boxes.Add(EditShape.Box(shown.Source.Grid, min, max));
            Begin(shown, operation);
        }

        public void ApplyLasso(PointCloud cloud)
        {
            var shown = SceneExport.FindStreamed(cloud, out _);
            if (Lasso.Count == 0 || !CanEdit(shown))
                return;
            var corners = Lasso.ConvertAll(ray => GeoOf(shown, ray.OriginWorld + ray.DirectionWorld));
            var from = GeoOf(shown, Lasso[0].OriginWorld);
            // Rays of an eye widen.
            var eye = Lasso[0].RadiusPerUnit > 0 ? new double4(from, 1) : new double4(from - corners[0], 0);
            var operation = NewOperation(IdOf(shown));
            Note = operation.SetLasso(shown.Source.Grid, eye, corners);
            if (Note == null)
                Begin(shown, operation);
        }

        static double3 GeoOf(StreamedCloud shown, double3 world) => shown.Source.Grid.ToGeo(shown.Source.Root.Corner) +
            math.mul(math.inverse(shown.Placement.Linear), world - shown.Placement.OriginWorld);

        public void Dispose()
        {
            ClearStroke();
            m_picker.Dispose();
        }

        void BeginNext()
        {
            if (!m_hasNext || m_picker.IsSearching)
                return;
            m_hasNext = false;
            if (!m_picker.Begin(m_next))
                Note = "no point cloud is shown";
        }

        bool AddToStroke(StreamPick pick)
        {
            Note = pick.Failure;
            if (pick.Point == null || m_stroke.Count > 0 && m_stroke[0].Path != pick.Path)
                return pick.Failure != null;
            // What hardly moved would only make the stroke longer.
            if (m_stroke.Count > 0 && math.distance(m_stroke[m_stroke.Count - 1].Point.PositionWorld, pick.Point.PositionWorld) <
                Radius / 16)
                return false;
            if (m_stroke.Count == 0 && (m_entity = m_picker.EntityOf(pick.Cloud)) == Entity.Null)
            {
                m_hasNext = !m_isEnding; // Another state was shown meanwhile.
                return false;
            }
            if (m_stroke.Count == 0)
                (m_journal, m_cloudId) = (EditJournal.PathOf(pick.Path), IdOf(FindShown()));
            m_stroke.Add(pick);
            return true;
        }

        StreamedCloud FindShown()
        {
            var group = PointCloudSystemGroup.ObjectGroup;
            int number = group?.Stream == null || group.Live.Find(m_entity)?.Versions == null ? CloudVersions.None
                : group.Live.Find(m_entity).Versions.ShownNumber;
            return number < 0 ? null : group.Stream.Clouds[number];
        }

        // None of a preview.
        static ulong IdOf(StreamedCloud shown) => (shown?.Source as FolderSource)?.Folder.Manifest.CloudId ?? 0;

        // One state after the other: each is shown before the next begins.
        void ShowStroke()
        {
            var shown = FindShown();
            if (!IsEditable(shown))
                return;
            var source = (FolderSource)shown.Source;
            bool isThere = EditJournal.DraftAt(m_journal) == m_draft;
            double now = Time.realtimeSinceStartupAsDouble;
            if (m_draftLength == m_stroke.Count)
            {
                if (!isThere && m_draft != null)
                    EditJournal.SetDraft(m_journal, m_draft); // What was written meanwhile took it away.
                return;
            }
            if (now < m_nextDraft || isThere && m_draft != null && source.Edits?.Last != m_draft)
                return;
            var draft = AddStroke(shown, NewOperation(m_cloudId));
            if (Action < EditAction.Classify || Action == EditAction.Classify && IsHidden(Class))
                (draft.Action, draft.Value) = (EditAction.Color, s_mark);
            (m_draftLength, m_nextDraft) = (m_stroke.Count, now + DraftSeconds);
            if (Shows(source, draft.ChangedAttributes[0]) && EditPlan.FindProblem(draft, source.Folder.Manifest) == null)
                EditJournal.SetDraft(m_journal, m_draft = draft);
        }

        bool IsHidden(byte pointClass)
        {
            var entities = PointCloudSystemGroup.ObjectGroup.World.EntityManager;
            return entities.HasComponent<PointCloudLook>(m_entity) &&
                entities.GetComponentData<PointCloudLook>(m_entity).Value.HiddenClasses.Has(pointClass);
        }

        static bool Shows(FolderSource source, string attribute)
        {
            foreach (int p in source.Planes)
                for (int c = 0; c < source.Layout.Planes[p].ColumnCount; c++)
                    if (source.Layout.NameOfColumn(source.Layout.Planes[p], source.Layout.Planes[p].FirstColumn + c) == attribute)
                        return true;
            return false;
        }

        EditOperation AddStroke(StreamedCloud shown, EditOperation operation)
        {
            var linear = shown.Placement.Linear;
            var radii = Radius / (new double3(math.length(linear.c0), math.length(linear.c1), math.length(linear.c2)) *
                shown.Source.Grid.Step);
            // The same on all axes where only rounding says otherwise: such balls may be larger.
            if (math.cmax(radii) - math.cmin(radii) < 1e-6 * math.cmin(radii))
                radii = math.cmin(radii);
            foreach (var pick in m_stroke)
                operation.Balls.Add(new EditShape
                {
                    A = pick.Point.Position,
                    B = EditShape.GridOf(math.max(1, math.floor(radii))),
                    IsBall = true,
                });
            return operation;
        }

        bool CanEdit(StreamedCloud shown)
        {
            Note = shown == null ? "the cloud is not shown"
                : IsEditable(shown) ? null : "only converted clouds on this machine can be edited";
            return Note == null;
        }

        static bool IsEditable(StreamedCloud shown) => shown?.Source is FolderSource stored && !stored.Folder.IsUnfinished &&
            !SourcePath.IsRemote(stored.Folder.FolderPath);

        EditOperation NewOperation(ulong cloudId) => new EditOperation
        {
            CloudId = cloudId,
            Action = Action,
            Value = Action == EditAction.Classify ? new[] { Class }
                : Action == EditAction.Color ? new[] { ByteOf(Color.r), ByteOf(Color.g), ByteOf(Color.b) }
                : new byte[0],
        };

        static byte ByteOf(float channel) => (byte)math.round(math.saturate(channel) * byte.MaxValue);

        bool Begin(StreamedCloud shown, EditOperation operation)
        {
            var folder = ((FolderSource)shown.Source).Folder;
            Note = EditPlan.FindProblem(operation, folder.Manifest);
            if (Note == null)
                EditQueue.Begin(folder.FolderPath, operation, m_draft, "Edit points");
            return Note == null;
        }
    }
}
