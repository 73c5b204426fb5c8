using System;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Build
{
    /// <summary>A box of a cloud, in grid steps from the root's corner, and how its points' neighbours are chosen.</summary>
    internal struct NormalRegion
    {
        public double3 Min; // Points in this box, its upper ends left out, get a normal.
        public double3 Max;
        public double MarginMetres; // Their neighbours are up to so far from it.
        public double3 StepMetres; // Along each axis.
        public int Neighbours; // How many neighbours of a point its plane is laid through, besides the point.

        public readonly double3 OuterMin => Min - MarginMetres / StepMetres;
        public readonly double3 OuterMax => Max + MarginMetres / StepMetres;
    }

    /// <summary>The points of a region along the Z curve, at its finest cells of 2^-21 of its longest side; in metres from its
    /// corner.</summary>
    internal unsafe struct RegionPoints : IDisposable
    {
        const int BucketBits = 18;
        const int BucketShift = 3 * Morton.BitsPerAxis - BucketBits;

        public NativeArray<double> X;
        public NativeArray<double> Y;
        public NativeArray<double> Z;
        public NativeArray<ulong> Codes;
        public NativeArray<uint> Ids; // By point: its index in the batch.
        public NativeArray<int> FirstOfBucket; // With one more entry, the number of points.
        public double FinestCellMetres; // Their edge.
        internal NativeArray<ulong> FoundCodes; // As they are found, then free.
        internal NativeArray<uint> FoundIds;
        internal NativeReference<int> Count;

        public RegionPoints(int capacity, in NormalRegion region)
        {
            const NativeArrayOptions raw = NativeArrayOptions.UninitializedMemory;
            X = new NativeArray<double>(capacity, Allocator.Persistent, raw);
            Y = new NativeArray<double>(capacity, Allocator.Persistent, raw);
            Z = new NativeArray<double>(capacity, Allocator.Persistent, raw);
            Codes = new NativeArray<ulong>(capacity, Allocator.Persistent, raw);
            Ids = new NativeArray<uint>(capacity, Allocator.Persistent, raw);
            FoundCodes = new NativeArray<ulong>(capacity, Allocator.Persistent, raw);
            FoundIds = new NativeArray<uint>(capacity, Allocator.Persistent, raw);
            FirstOfBucket = new NativeArray<int>((1 << BucketBits) + 1, Allocator.Persistent);
            Count = new NativeReference<int>(Allocator.Persistent);
            double side = math.cmax((region.OuterMax - region.OuterMin) * region.StepMetres);
            FinestCellMetres = math.max(side, double.Epsilon * (1L << 40)) / (Morton.MaxCoordinate + 1.0);
        }

        public static int BucketOf(ulong code) => (int)(code >> BucketShift);

        /// <summary>The first point whose code is no smaller.</summary>
        public static int FirstNotBelow(ulong* codes, int* firstOfBucket, ulong code)
        {
            int bucket = BucketOf(code);
            if (bucket >= 1 << BucketBits)
                return firstOfBucket[1 << BucketBits];
            int first = firstOfBucket[bucket], count = firstOfBucket[bucket + 1] - first;
            while (count > 0)
            {
                int half = count / 2;
                bool isBehind = codes[first + half] < code;
                first = isBehind ? first + half + 1 : first;
                count = isBehind ? count - half - 1 : half;
            }
            return first;
        }

        public void Dispose()
        {
            if (!X.IsCreated)
                return;
            X.Dispose();
            Y.Dispose();
            Z.Dispose();
            Codes.Dispose();
            Ids.Dispose();
            FoundCodes.Dispose();
            FoundIds.Dispose();
            FirstOfBucket.Dispose();
            Count.Dispose();
        }
    }

    /// <summary>A slice of listing a batch's points that are in a region or its margin. Slices run one after another.</summary>
    [BurstCompile]
    internal unsafe struct ListRegionJob : IJob
    {
        public const int PointsPerSlice = 100000; // A slice takes about 2 ms.

        public int First;
        public int End;
        public NormalRegion Region;
        [ReadOnly] public NativeArray<double> X;
        [ReadOnly] public NativeArray<double> Y;
        [ReadOnly] public NativeArray<double> Z;
        public RegionPoints Points;

        public SliceTimes SliceTimes;

        public void Execute()
        {
            long begin = SliceTimes.Begin();
            double3 min = Region.OuterMin, size = Region.OuterMax - min, scale = Region.StepMetres / Points.FinestCellMetres;
            double* x = (double*)X.GetUnsafeReadOnlyPtr(), y = (double*)Y.GetUnsafeReadOnlyPtr(),
                z = (double*)Z.GetUnsafeReadOnlyPtr();
            var codes = (ulong*)Points.FoundCodes.GetUnsafePtr();
            var ids = (uint*)Points.FoundIds.GetUnsafePtr();
            var counts = (int*)Points.FirstOfBucket.GetUnsafePtr() + 1;
            int count = Points.Count.Value;
            for (int i = First; i < End; i++)
            {
                var p = new double3(x[i], y[i], z[i]) - min;
                if (!(math.all(p >= 0) && math.all(p <= size)))
                    continue;
                var cell = p * scale;
                ulong code = Morton.Encode(math.min((uint)cell.x, Morton.MaxCoordinate),
                    math.min((uint)cell.y, Morton.MaxCoordinate), math.min((uint)cell.z, Morton.MaxCoordinate));
                codes[count] = code;
                ids[count++] = (uint)i;
                counts[RegionPoints.BucketOf(code)]++;
            }
            Points.Count.Value = count;
            SliceTimes.End(begin);
        }
    }

    /// <summary>A slice of bringing listed points into their buckets. Slices run one after another.</summary>
    [BurstCompile]
    internal unsafe struct ScatterRegionJob : IJob
    {
        public const int PointsPerSlice = 200000;

        public int First;
        public int End;
        public RegionPoints Points;

        public SliceTimes SliceTimes;

        public void Execute()
        {
            long begin = SliceTimes.Begin();
            // Where a bucket's next point goes, one entry behind: after the last slice, where the next bucket begins.
            var next = (int*)Points.FirstOfBucket.GetUnsafePtr() + 1;
            int buckets = Points.FirstOfBucket.Length - 1;
            for (int b = 0, sum = 0; First == 0 && b < buckets; b++)
            {
                int count = next[b];
                next[b] = sum;
                sum += count;
            }
            var codes = (ulong*)Points.FoundCodes.GetUnsafeReadOnlyPtr();
            var ids = (uint*)Points.FoundIds.GetUnsafeReadOnlyPtr();
            var toCodes = (ulong*)Points.Codes.GetUnsafePtr();
            var toIds = (uint*)Points.Ids.GetUnsafePtr();
            for (int i = First; i < End; i++)
            {
                int to = next[RegionPoints.BucketOf(codes[i])]++;
                toCodes[to] = codes[i];
                toIds[to] = ids[i];
            }
            SliceTimes.End(begin);
        }
    }

    /// <summary>A slice of sorting the points of buckets that begin in a range, and of placing them. Slices run side by
    /// side.</summary>
    [BurstCompile]
    internal unsafe struct SortRegionJob : IJob
    {
        public const int PointsPerSlice = 40000; // A slice takes about 3 ms, unless one of 262,144 cells has more points.

        public int First;
        public int End;
        public NormalRegion Region;
        [ReadOnly] public NativeArray<double> X;
        [ReadOnly] public NativeArray<double> Y;
        [ReadOnly] public NativeArray<double> Z;
        [NativeDisableContainerSafetyRestriction] public RegionPoints Points; // Each slice has its own points of it.

        public void Execute()
        {
            int bucket = BucketAt(First), last = BucketAt(End);
            var starts = Points.FirstOfBucket;
            int begin = starts[bucket], end = starts[last];
            var codes = (ulong*)Points.Codes.GetUnsafePtr();
            var ids = (uint*)Points.Ids.GetUnsafePtr();
            for (; bucket < last; bucket++)
            {
                int first = starts[bucket];
                RadixSort.Sort(codes + first, ids + first, (ulong*)Points.FoundCodes.GetUnsafePtr() + first,
                    (uint*)Points.FoundIds.GetUnsafePtr() + first, starts[bucket + 1] - first);
            }
            var min = Region.OuterMin;
            Place((double*)X.GetUnsafeReadOnlyPtr(), min.x, Region.StepMetres.x, begin, end, (double*)Points.X.GetUnsafePtr());
            Place((double*)Y.GetUnsafeReadOnlyPtr(), min.y, Region.StepMetres.y, begin, end, (double*)Points.Y.GetUnsafePtr());
            Place((double*)Z.GetUnsafeReadOnlyPtr(), min.z, Region.StepMetres.z, begin, end, (double*)Points.Z.GetUnsafePtr());
        }

        void Place(double* from, double min, double metres, int begin, int end, double* to)
        {
            var ids = (uint*)Points.Ids.GetUnsafeReadOnlyPtr();
            for (int i = begin; i < end; i++)
                to[i] = (from[ids[i]] - min) * metres;
        }

        /// <summary>The first bucket that begins at a point or behind it.</summary>
        int BucketAt(int point)
        {
            var starts = Points.FirstOfBucket;
            int low = 0, high = starts.Length - 1;
            while (low < high)
            {
                int middle = (low + high) / 2;
                if (starts[middle] < point)
                    low = middle + 1;
                else
                    high = middle;
            }
            return low;
        }
    }
}
