using FastPoints.Queries;
using FastPoints.Store;
using FastPoints.Streaming;
using NUnit.Framework;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Tests.Queries
{
    public sealed unsafe class BoxTreeRayTests
    {
        const int Leaves = 197; // The last eight are not full.

        [Test]
        public void Intersect_SeededBoxes_LosesNoPointAndIsThatWithoutIntrinsics([Values(0, 1e7)] double corner)
        {
            using var eights = new NativeArray<EightBoxes>(BoxTree.EightsOf(Leaves), Allocator.Persistent);
            var random = new Unity.Mathematics.Random(41);
            var tree = new BoxTree { Eights = (EightBoxes*)eights.GetUnsafePtr(), LeafCount = Leaves, Corner = corner };
            for (int i = 0; i < tree.LeafCount; i++)
            {
                var min = random.NextDouble3(-50, 50);
                tree.Eights[i / 8].Set(i % 8, min, min + random.NextDouble3(0, 8) * (i % 5));
            }
            tree.Build();
            float* starts = stackalloc float[8], plainStarts = stackalloc float[8];
            int hit = 0, held = 0;
            for (int i = 0; i < 300; i++)
            {
                // Some along an axis, some that narrow.
                var eye = random.NextDouble3(-90, 90);
                var aim = i % 7 == 0 ? eye - new double3(0, 0, 1) : random.NextDouble3(-50, 50);
                var query = PointQuery.Ray(corner + eye, aim - eye, random.NextDouble(0, 9));
                query.RadiusPerUnit = random.NextDouble(-0.02, 0.02);
                if (i % 100 == 1)
                    (query.Radius, query.RadiusPerUnit) = (double.PositiveInfinity, 0);
                var space = new QuerySpace(query, new CloudPlacement(double3x3.identity, 0));
                var rays = space.RayFor(tree);
                for (int first = 0; first < tree.LeafCount; first += 8)
                {
                    int hits = BoxTreeRay.Intersect(&rays, tree.Eights + first / 8, starts);
                    Assert.That(BoxTreeRay.IntersectPlain(&rays, tree.Eights + first / 8, plainStarts), Is.EqualTo(hits));
                    for (int box = 0; box < math.min(8, tree.LeafCount - first); box++)
                    {
                        bool isHit = (hits >> box & 1) != 0;
                        hit += isHit ? 1 : 0;
                        if (isHit)
                            Assert.That(plainStarts[box], Is.EqualTo(starts[box]));
                        tree.Eights[first / 8].Get(box, out var middle, out var half);
                        for (int n = 0; n < 8; n++)
                        {
                            var position = tree.Corner + middle + half * math.clamp(random.NextDouble3(-2, 2), -1, 1);
                            if (!space.Holds(space.RelativeToOrigin(position), out double distance, out _))
                                continue;
                            held++;
                            Assert.That(isHit && distance >= rays.Base + starts[box], Is.True);
                        }
                    }
                }
            }
            Assert.That(hit, Is.InRange(1000, 10_000));
            Assert.That(held, Is.GreaterThan(1000));
        }

        [Test]
        public void MayHold_SeededPoints_LosesNoneAndIsThatWithoutIntrinsics()
        {
            var random = new Unity.Mathematics.Random(42);
            uint* steps = stackalloc uint[24];
            int held = 0;
            for (int i = 0; i < 2000; i++)
            {
                double step = math.exp2(random.NextInt(-20, 4));
                var at = random.NextDouble3(-1e6, 1e6);
                var query = PointQuery.FromEye(random.NextDouble3(-1e6, 1e6), at, 1, random.NextDouble(0, 0.5));
                query.DirectionWorld = math.normalize(at - query.OriginWorld);
                var space = new QuerySpace(query, new CloudPlacement(double3x3.identity, 0));
                var filter = new BlockFilter(query, space, step);
                uint size = 1u << random.NextInt(1, 31);
                filter.Begin(space.RelativeToOrigin(at), new float3(size, size, size), double.PositiveInfinity);
                for (int n = 0; n < 24; n++)
                    steps[n] = random.NextUInt(size);
                int hits = filter.MayHold(steps, steps + 8, steps + 16);
                Assert.That(filter.MayHoldPlain(steps, steps + 8, steps + 16), Is.EqualTo(hits));
                for (int n = 0; n < 8; n++)
                {
                    var position = at + new double3(steps[n], steps[8 + n], steps[16 + n]) * step;
                    bool isHeld = space.Holds(space.RelativeToOrigin(position), out _, out _);
                    held += isHeld ? 1 : 0;
                    Assert.That(!isHeld || (hits >> n & 1) != 0, Is.True);
                }
            }
            Assert.That(held, Is.InRange(1000, 15_000));
        }

        [Test]
        public void Order_BoxesOfAPlaneInDisorder_KeepsThemAllAndMakesSmallParents()
        {
            const int Side = 24, Count = Side * Side;
            using var eights = new NativeArray<EightBoxes>(BoxTree.EightsOf(Count), Allocator.Persistent);
            var tree = new BoxTree { Eights = (EightBoxes*)eights.GetUnsafePtr(), LeafCount = Count };
            for (int i = 0; i < Count; i++)
                tree.Eights[i / 8].Set(i % 8, MinOf(i, Side), MinOf(i, Side) + 1);
            uint* order = stackalloc uint[Count];
            tree.Order(order);
            tree.Build();
            var isThere = new bool[Count];
            for (int i = 0; i < Count; i++)
            {
                tree.Eights[i / 8].Get(i % 8, out var middle, out _);
                Assert.That(middle, Is.EqualTo(MinOf((int)order[i], Side) + 0.5));
                isThere[order[i]] = true;
            }
            Assert.That(isThere, Is.All.True);
            var parents = tree.BoxesOfLevel(1, out int count);
            double area = 0;
            for (int i = 0; i < count; i++)
            {
                parents[i / 8].Get(i % 8, out _, out var half);
                area += 4 * half.x * half.y;
            }
            Assert.That(area, Is.InRange(Count, 1.5 * Count));
        }

        static double3 MinOf(int box, int side) => new double3(box * 7 % side, box / side * 5 % side, 0);

        [TestCase(128, 0, 16), TestCase(128, 37, 32), TestCase(77, 76, 16), TestCase(5, 0, 1), TestCase(1, 0, 1)]
        public void Build_PointsOfALine_RunsEndAtJumpsAndAreEqualWithout(int points, int jump, int longest)
        {
            uint* plane = stackalloc uint[1024];
            ulong XOf(int i) => (ulong)(i < jump ? 10 * i : 10 * i + 999);
            var view = WriteLine(plane, points, XOf);
            var eights = stackalloc EightBoxes[BoxTree.EightsOf(PointRun.PerBlock)];
            var runs = stackalloc PointRun[PointRun.PerBlock];
            using var isDamaged = new NativeArray<bool>(1, Allocator.Persistent);
            var tree = new BoxTree { Eights = eights, LeafCount = PointRun.PerBlock };
            new FindRunsJob { IsDamaged = isDamaged, Positions = view, Tree = tree, Runs = runs, Step = 1 }.Execute(0);
            new BuildResidentNodeJob { IsDamaged = isDamaged, Tree = tree, Runs = runs }.Execute();
            var isFound = new bool[points];
            bool isEnd = jump == 0;
            for (int run = 0; run < PointRun.PerBlock; run++)
            {
                isEnd |= runs[run].First == jump;
                Assert.That(runs[run].Count, Is.LessThanOrEqualTo(longest));
                eights[0].Get(run, out var middle, out var half);
                for (int i = runs[run].First; i < runs[run].First + runs[run].Count; i++)
                {
                    Assert.That(isFound[i], Is.False);
                    isFound[i] = math.abs(XOf(i) - middle.x) <= half.x;
                }
            }
            Assert.That(isFound, Is.All.True);
            Assert.That(isEnd, Is.True);
        }

        [Test]
        public void Search_PositionsOfMoreThan32Bits_FindsThoseOfAnyRun()
        {
            const int Points = 20;
            uint* plane = stackalloc uint[1024];
            ulong* scratch = stackalloc ulong[NodeSearch.ScratchCount];
            PickHit* hits = stackalloc PickHit[Points];
            var search = new NodeSearch { Positions = WriteLine(plane, Points, i => (ulong)i << 40), Step = 1 };
            search.Space = new QuerySpace(PointQuery.Sphere(0, 1e20), new CloudPlacement(double3x3.identity, 0));
            for (int first = 0; first < Points; first++)
                for (int count = 1; first + count <= Points; count++)
                {
                    var heap = new HitHeap(hits, Points, false, PickHit.None);
                    search.Search(0, first, count, scratch, ref heap);
                    heap.Sort();
                    Assert.That(heap.Totals.Count, Is.EqualTo(count));
                    for (int i = 0; i < count; i++)
                        Assert.That((heap[i].Index, heap[i].Position.X), Is.EqualTo((first + i, (long)(first + i) << 40)));
                }
        }

        static PlaneView WriteLine(uint* plane, int points, System.Func<int, ulong> xOf)
        {
            ulong* values = stackalloc ulong[3 * PlaneShape.MaxPointsPerBlock], bounds = stackalloc ulong[6];
            for (int i = 0; i < points; i++)
                (BlockWriter.WideOf(values, 0)[i], BlockWriter.WideOf(values, 1)[i], BlockWriter.WideOf(values, 2)[i]) =
                    (xOf(i), 5, 5);
            var shape = PlaneShape.OfPositions(true);
            var writer = new BlockWriter(plane, shape, 0, shape.DescriptorWords);
            writer.Write(values, points, bounds, bounds + 3);
            writer.End();
            return new PlaneView(plane, shape, 1);
        }
    }
}
