using System;
using System.Collections.Generic;
using FastPoints.Drawing;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Mathematics;

namespace FastPoints.Queries
{
    // Searches all clouds of a stream as they are stored, one after the other, with pickers that are kept for the next search.
    // Main thread.
    sealed class FullDetailSearch : IDisposable
    {
        readonly StreamContext m_stream;
        readonly List<Kept> m_pickers = new List<Kept>();

        struct Kept
        {
            public NodeSource Streamed; // May have been disposed since.
            public PointPicker Picker;
            public bool IsRented;
        }

        public FullDetailSearch(StreamContext stream) => m_stream = stream;

        // A null list only counts.
        public IEnumerator<JobStep> Find(PointQuery query, int maxHits, List<PointHit> hits)
        {
            if (maxHits < 0)
                throw new ArgumentException("wanted 0 hits or more, got " + maxHits);
            hits.Clear();
            var options = new PickOptions { MaxHits = maxHits, FindsNormals = maxHits > 0 };
            return SearchAll(query, options, (picker, cloud, placement) =>
            {
                var metres = picker.Source.Crs.Units.MetresAt(picker.Source.Grid.ToGeo(picker.Source.Root.Corner), UpAxis.Z);
                var normalsToWorld = DrawListCloud.NormalsToWorld(placement.Linear, metres);
                for (int i = 0; i < picker.Hits.Totals.Count; i++)
                {
                    var hit = Describe(picker, picker.Hits[i], cloud, placement);
                    hit.NormalWorld = OctahedralNormal.ToWorld(picker.Hits[i].Normal, normalsToWorld);
                    hits.Add(hit);
                }
                // Of several clouds, the first of all.
                hits.Sort((a, b) => a.Distance != b.Distance ? a.Distance.CompareTo(b.Distance) : a.Cloud.CompareTo(b.Cloud));
                if (hits.Count > maxHits)
                    hits.RemoveRange(maxHits, hits.Count - maxHits);
            }, null);
        }

        public IEnumerator<JobStep> Count(PointQuery query, Action<long> done)
        {
            long count = 0;
            return SearchAll(query, new PickOptions { MaxHits = 0, CountsAll = true },
                (picker, cloud, placement) => count += picker.Hits.Totals.Matches, () => done(count));
        }

        public IEnumerator<JobStep> Read(PointHit hit, Action<PickedPoint> done)
        {
            var streamed = hit.Cloud < m_stream.Clouds.Count ? m_stream.Clouds[hit.Cloud] : null;
            var result = new PickResult();
            if (streamed != null)
            {
                int kept = -1;
                try
                {
                    yield return JobStep.Of(Rent(streamed.Source, rented => kept = rented));
                    if (kept >= 0)
                    {
                        // In the cloud's own space no transform rounds.
                        var source = m_pickers[kept].Picker.Source;
                        var at = PointQuery.Sphere(source.Grid.ToGeo(hit.Position), 0.25 * math.cmin(source.Grid.Step));
                        yield return JobStep.Of(m_pickers[kept].Picker.Find(at, CloudPlacement.Geo(source.Grid, source.Root),
                            Unlimited(new PickOptions()), result));
                    }
                }
                finally
                {
                    Return(kept);
                }
            }
            done(result.Point);
        }

        // Those of clouds that the stream no longer has.
        public void ReleaseRemoved()
        {
            for (int i = m_pickers.Count - 1; i >= 0; i--)
                if (!m_pickers[i].IsRented && !IsStreamed(m_pickers[i].Streamed))
                {
                    m_pickers[i].Picker?.Dispose();
                    m_pickers[i] = default;
                }
        }

        public void Dispose()
        {
            foreach (var kept in m_pickers)
                kept.Picker?.Dispose();
            m_pickers.Clear();
        }

        IEnumerator<JobStep> SearchAll(PointQuery query, PickOptions options, Action<PointPicker, int, CloudPlacement> found,
            Action done)
        {
            for (int c = 0; c < m_stream.Clouds.Count; c++)
            {
                var streamed = m_stream.Clouds[c];
                if (streamed == null || streamed.IsRemoving)
                    continue;
                var placement = streamed.Placement;
                var source = streamed.Source;
                int kept = -1;
                try
                {
                    yield return JobStep.Of(Rent(source, rented => kept = rented));
                    if (kept < 0)
                        continue;
                    var picker = m_pickers[kept].Picker;
                    options.Cloud = c;
                    placement = placement.ForVersion(source, picker.Source);
                    yield return JobStep.Of(picker.Search(query, placement, Unlimited(options), new PickResult()));
                    found(picker, c, placement);
                }
                finally
                {
                    Return(kept);
                }
            }
            done?.Invoke();
        }

        static PickOptions Unlimited(PickOptions options)
        {
            options.FinestSpacingShare = 0;
            options.MaxBytes = long.MaxValue;
            return options;
        }

        // Gives the index of a picker, or none if the cloud is gone.
        IEnumerator<JobStep> Rent(NodeSource streamed, Action<int> rented)
        {
            for (int i = 0; i < m_pickers.Count; i++)
                if (m_pickers[i].Streamed == streamed && !m_pickers[i].IsRented && m_pickers[i].Picker != null)
                {
                    SetRented(i, true);
                    rented(i);
                    yield break;
                }
            NodeSource opened = null;
            yield return JobStep.Of(streamed.OpenForPicking(source => opened = source));
            if (opened == null)
                yield break;
            int free = m_pickers.FindIndex(kept => kept.Picker == null);
            var added = new Kept { Streamed = streamed, Picker = new PointPicker(opened), IsRented = true };
            if (free < 0)
                m_pickers.Add(added);
            else
                m_pickers[free] = added;
            rented(free < 0 ? m_pickers.Count - 1 : free);
        }

        void Return(int kept)
        {
            // All have ended with the stream.
            if (kept < 0 || kept >= m_pickers.Count)
                return;
            m_pickers[kept].Picker.TrimHierarchy();
            SetRented(kept, false);
        }

        void SetRented(int index, bool value)
        {
            var kept = m_pickers[index];
            kept.IsRented = value;
            m_pickers[index] = kept;
        }

        bool IsStreamed(NodeSource source)
        {
            for (int c = 0; c < m_stream.Clouds.Count; c++)
                if (m_stream.Clouds[c]?.Source == source)
                    return true;
            return false;
        }

        static PointHit Describe(PointPicker picker, in PickHit hit, int cloud, in CloudPlacement placement)
        {
            var from = hit.Position - picker.Source.Root.Corner;
            return new PointHit
            {
                PositionWorld = math.mul(placement.Linear, new double3(from.X, from.Y, from.Z) * picker.Source.Grid.Step) +
                    placement.OriginWorld,
                PositionGeo = picker.Source.Grid.ToGeo(hit.Position),
                Position = hit.Position,
                Distance = hit.Distance,
                // What a preview lacks may lie anywhere.
                SpacingWorld = picker.Source.HasAllPoints ? 0 : double.PositiveInfinity,
                Cloud = cloud,
                Slot = NodeState.NoSlot,
            };
        }
    }
}
