using System;
using System.Collections.Generic;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Queries
{
    /// <summary>Asks a stream's clouds for points. At once, and in jobs, from copies of the nodes that are on the graphics card:
    /// the answer is as fine as the picture. Or in full detail from all that is stored, in coroutines that read. Clip boxes and
    /// hidden classes change nothing. The copies take memory from the first use of <see cref="Resident"/> or a batch
    /// on. Main thread.</summary>
    public sealed class PointCloudQueries : IDisposable
    {
        /// <summary>Bytes of copies if no other limit is set.</summary>
        public const long DefaultBudgetBytes = 256 << 20;

        readonly StreamContext m_stream;
        readonly FullDetailSearch m_stored;
        ResidentCopy m_copy;

        /// <param name="stream">It is disposed after these queries.</param>
        public PointCloudQueries(StreamContext stream)
        {
            m_stream = stream;
            m_stored = new FullDetailSearch(stream);
        }

        /// <summary>The copies take no more; nodes that cameras need most come first.</summary>
        public long BudgetBytes { get; set; } = DefaultBudgetBytes;

        /// <summary>Bytes of the copies now.</summary>
        public long Bytes => m_copy?.Bytes ?? 0;

        /// <summary>Whether everything that was resident in the last frame has its copy: false while they are made, and beyond
        /// the budget.</summary>
        public bool IsComplete => m_copy != null && m_copy.IsComplete;
        internal bool IsCopying => m_copy != null && m_copy.IsReading; // Whether another frame would bring copies.

        /// <summary>What is in memory, for searches at once and in jobs; empty at first. It is valid until the next
        /// <see cref="Update"/>, unless a job that reads it was given to <see cref="AddReader"/>.</summary>
        public ResidentPoints Resident => Copy.Points;

        /// <summary>Follows the stream, once a frame after <see cref="FrameStep"/>. It never waits: while a job reads the copies,
        /// they stay as they are.</summary>
        public void Update()
        {
            m_stored.ReleaseRemoved();
            m_copy?.Update(BudgetBytes);
        }

        /// <summary>The copies do not change before a job of yours that reads <see cref="Resident"/> is done.</summary>
        public void AddReader(JobHandle job) => Copy.AddReader(job);

        /// <summary>Finds the first points of many queries in memory, in jobs.</summary>
        /// <param name="maxHits">How many are wanted of each query.</param>
        /// <param name="hits">So many places for each query: the first point first.</param>
        /// <param name="countOfQuery">Receives how many of them hold a hit.</param>
        /// <exception cref="ArgumentException">An array is too short.</exception>
        public JobHandle Schedule(NativeArray<PointQuery> queries, int maxHits, NativeArray<PointHit> hits,
            NativeArray<int> countOfQuery, JobHandle inputDeps = default)
        {
            if (maxHits < 0 || hits.Length < (long)queries.Length * maxHits || countOfQuery.Length < queries.Length)
                throw new ArgumentException("wanted room for " + maxHits + " hits of " + queries.Length + " queries, got " +
                    hits.Length + " hits and " + countOfQuery.Length + " counts");
            var job = new FindPointsJob
            {
                Points = Copy.Points,
                Queries = queries,
                MaxHits = maxHits,
                Hits = hits,
                CountOfQuery = countOfQuery,
            }.ScheduleParallel(queries.Length, QueriesPerSlice, inputDeps);
            m_copy.AddReader(job);
            return job;
        }

        /// <summary>Counts the points of many queries in memory, in jobs.</summary>
        /// <exception cref="ArgumentException">There are fewer counts than queries.</exception>
        public JobHandle ScheduleCounts(NativeArray<PointQuery> queries, NativeArray<long> pointsOfQuery,
            JobHandle inputDeps = default)
        {
            if (pointsOfQuery.Length < queries.Length)
                throw new ArgumentException("wanted " + queries.Length + " counts, got " + pointsOfQuery.Length);
            var job = new CountPointsJob { Points = Copy.Points, Queries = queries, PointsOfQuery = pointsOfQuery }
                .ScheduleParallel(queries.Length, 1, inputDeps);
            m_copy.AddReader(job);
            return job;
        }

        /// <summary>Reads an attribute of a point that was found in memory.</summary>
        /// <returns>False if its node or the attribute is not in memory: see <see cref="ReadAllAttributes"/>.</returns>
        public bool TryRead(in PointHit hit, string attribute, out double value)
        {
            value = 0;
            if (m_copy == null || hit.Cloud >= m_stream.Clouds.Count || m_stream.Clouds[hit.Cloud] == null)
                return false;
            var source = m_stream.Clouds[hit.Cloud].Source;
            int index = source.Layout.Attributes.IndexOf(attribute);
            for (int p = 1; index >= 0 && p < source.Planes.Length; p++)
            {
                var plane = source.Layout.Planes[source.Planes[p]];
                for (int c = 0; c < plane.ColumnCount && plane.AverageOf < 0; c++)
                    if (source.Layout.AttributeOfColumn[plane.FirstColumn + c] == index &&
                        m_copy.TryRead(hit, p, c, out ulong packed))
                    {
                        value = new PickedAttribute(source.Layout.Attributes[index], packed,
                            source.Layout.Columns[plane.FirstColumn + c]).Value;
                        return true;
                    }
            }
            return false;
        }

        /// <summary>Coroutine: finds the first points among all that are stored. Memory is bounded by their number and a few
        /// nodes. Cancelling it leaves nothing behind.</summary>
        /// <param name="hits">Receives them, the first one first.</param>
        /// <exception cref="PointCloudException">A cloud cannot be read.</exception>
        public IEnumerator<JobStep> FindInFullDetail(PointQuery query, int maxHits, List<PointHit> hits) =>
            m_stored.Find(query, maxHits, hits);

        /// <summary>Coroutine: counts the points among all that are stored.</summary>
        /// <exception cref="PointCloudException">A cloud cannot be read.</exception>
        public IEnumerator<JobStep> CountInFullDetail(PointQuery query, Action<long> done) => m_stored.Count(query, done);

        /// <summary>Coroutine: reads all attributes of a point that was found; of several in one place, of the first.</summary>
        /// <param name="done">Receives null if the cloud is gone, or is another by now.</param>
        /// <exception cref="PointCloudException">The cloud cannot be read.</exception>
        public IEnumerator<JobStep> ReadAllAttributes(PointHit hit, Action<PickedPoint> done) => m_stored.Read(hit, done);

        /// <summary>Ends what is in flight and frees the copies. Coroutines must be done or cancelled.</summary>
        public void Dispose()
        {
            m_copy?.Dispose();
            m_copy = null;
            m_stored.Dispose();
        }

        const int QueriesPerSlice = 8;

        ResidentCopy Copy => m_copy ??= new ResidentCopy(m_stream);
    }
}
