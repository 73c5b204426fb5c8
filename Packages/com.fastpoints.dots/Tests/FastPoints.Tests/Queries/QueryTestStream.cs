using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using FastPoints.Queries;
using FastPoints.Store;
using FastPoints.Streaming;
using NUnit.Framework;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Tests.Queries
{
    /// <summary>A stream of one cloud with everything in view, and its queries.</summary>
    sealed class QueryTestStream : IDisposable
    {
        const int MaxFrames = 200_000;

        readonly MemoryNodePool m_pool = new MemoryNodePool(512 << 20, 1 << 20);
        NativeArray<StreamView> m_views =
            new NativeArray<StreamView>(1, Allocator.Persistent) { [0] = StreamView.Everything(1e9) };

        public QueryTestStream(NodeSource source, CloudPlacement? placement = null, long pointBudget = long.MaxValue)
        {
            Stream = new StreamContext(m_pool);
            Queries = new PointCloudQueries(Stream);
            PointBudget = pointBudget;
            Cloud = Stream.Add(source, placement ?? CloudPlacement.Geo(source.Grid, source.Root));
        }

        public StreamContext Stream { get; }
        public PointCloudQueries Queries { get; }
        public int Cloud { get; }

        public long PointBudget
        {
            set => Stream.Settings.Selection = new LodSettings { PointBudget = value, Hysteresis = 1 };
        }

        public bool Frame()
        {
            bool isSettled = FrameStep.Run(Stream, m_views).IsSettled;
            Queries.Update();
            return isSettled;
        }

        /// <summary>Until all that is shown is in memory and has its copy.</summary>
        public ResidentPoints Settle()
        {
            var points = Queries.Resident;
            for (int frame = 0; frame < MaxFrames; frame++, Thread.Yield())
                if (Frame() & Queries.IsComplete)
                    return Queries.Resident;
            Assert.Fail("the copies did not come to rest");
            return points;
        }

        /// <summary>By the pool's own bytes: world positions of every resident point, by cloud and grid position.</summary>
        public unsafe List<(double3 World, Grid3 Position)> Resident()
        {
            var all = new List<(double3, Grid3)>();
            ulong* values = stackalloc ulong[3 * PlaneShape.MaxPointsPerBlock];
            foreach (var node in Stream.Cache.Nodes)
            {
                if (node.Phase != CachePhase.Resident)
                    continue;
                var cloud = Stream.Clouds[node.Cloud];
                var address = cloud.Pages[node.Page].Addresses[node.Node];
                var planes = new PlaneView(m_pool.AddressOf(node.Range), PlaneShape.OfPositions(address.IsWide),
                    cloud.Pages[node.Page].Nodes[node.Node].BlockCount);
                for (int block = 0; block < planes.BlockCount; block++)
                {
                    for (int axis = 0; axis < 3; axis++)
                        planes.UnpackWide(block, axis, values + axis * PlaneShape.MaxPointsPerBlock);
                    for (int i = 0; i < planes.PointsOf(block); i++)
                    {
                        var local = address.Corner + new Grid3((long)values[i], (long)values[PlaneShape.MaxPointsPerBlock + i],
                            (long)values[2 * PlaneShape.MaxPointsPerBlock + i]);
                        all.Add((math.mul(cloud.Placement.Linear, new double3(local.X, local.Y, local.Z) *
                            cloud.Source.Grid.Step) + cloud.Placement.OriginWorld, cloud.Source.Root.Corner + local));
                    }
                }
            }
            return all;
        }

        /// <summary>Distances of all points that a query asks for, by looking at each, in order.</summary>
        public static double[] Distances(PointQuery query, IEnumerable<double3> worlds) =>
            worlds.Select(world => DistanceOf(query, world)).Where(distance => distance >= 0).OrderBy(d => d).ToArray();

        static double DistanceOf(PointQuery query, double3 world)
        {
            var from = world - query.OriginWorld;
            if (query.Shape == QueryShape.Sphere)
                return math.length(from) <= query.Radius ? math.length(from) : -1;
            if (query.Shape == QueryShape.Box)
                return math.all(math.abs(math.mul(math.inverse(query.EdgesWorld), from)) <= 0.5 + 1e-9) ? math.length(from) : -1;
            double along = math.dot(from, query.DirectionWorld);
            double beside = math.length(math.cross(from, query.DirectionWorld));
            return along >= query.From && along <= query.To && beside <= query.RadiusAt(along) ? along : -1;
        }

        /// <summary>Hits have these distances; only rounding may decide otherwise at the end.</summary>
        public static void Check(PointHit[] hits, double[] wanted, int maxHits, double tolerance, string name)
        {
            Assert.That(hits.Length, Is.EqualTo(Math.Min(maxHits, wanted.Length)), name);
            for (int i = 0; i < hits.Length; i++)
                Assert.That(hits[i].Distance, Is.EqualTo(wanted[i]).Within(tolerance), name + ", hit " + i);
        }

        public static PointHit[] Find(ResidentPoints points, PointQuery query, int maxHits)
        {
            using var hits = new NativeArray<PointHit>(maxHits, Allocator.Persistent);
            return hits.GetSubArray(0, points.Find(query, hits)).ToArray();
        }

        public PointHit[] FindInFullDetail(PointQuery query, int maxHits)
        {
            var hits = new List<PointHit>();
            JobCoroutine.RunToEnd(Queries.FindInFullDetail(query, maxHits, hits));
            return hits.ToArray();
        }

        public long CountInFullDetail(PointQuery query)
        {
            long count = -1;
            JobCoroutine.RunToEnd(Queries.CountInFullDetail(query, found => count = found));
            return count;
        }

        public void Dispose()
        {
            Queries.Dispose();
            Stream.Dispose();
            m_views.Dispose();
        }
    }
}
