using System;
using FastPoints.Nodes;
using FastPoints.Reading;
using FastPoints.Store;

namespace FastPoints.Build
{
    /// <summary>Divides up a build's memory. What is stored depends on <see cref="PointsPerChunk"/> and
    /// <see cref="PointsPerBaseCell"/>, which sources and settings determine alone; the rest says how it is made.</summary>
    internal sealed class MemoryPlan
    {
        const long MaxPointsPerChunk = 1000000;

        // A chunk that a cube's octants made eight times smaller is still larger than a leaf.
        const long MinPointsPerChunk = 200000;

        /// <summary>The smallest chunk of records of any size: smaller ones would consist of tops alone.</summary>
        const long MinPointsOfLargeRecords = 1 << 16;
        const long MaxChunkBytes = 183 << 20; // What a chunk may take while it is indexed.

        const long ChunksPerBaseCell = 16;

        /// <summary>Sixteen neighbours are merged into a region of at least this many points: each round leaves fewer, and a
        /// small cloud has one.</summary>
        const long MinPointsPerRegion = 16 * StoreFormat.MaxPointsPerNode;
        const long MaxPlaceholderPoints = 1 << 17; // More points do not improve an overview; little memory means fewer.
        const long PlaceholderDivisor = 16;
        const int PoissonBytesPerPoint = 40; // Memory for darts, samples and their grid.

        /// <summary>Memory for the sum that a point adds to; for the sums of a third of the points, in a list that grows by
        /// doubling; and for the plane of colours and intensities written from them.</summary>
        const int AverageBytesPerPoint = 4 + 28 + 8;

        MemoryPlan() { }

        public long Points { get; private set; }

        public long PointsPerChunk { get; private set; }

        public long PointsPerBaseCell { get; private set; } // The most points of a base cell, by the estimate: see BaseCells.

        /// <summary>Points that the first partition plans cubes for: half of a chunk's, since cubes with more than a chunk's must
        /// be split, while joining costs nothing.</summary>
        public long PointsPerPlannedCube => Math.Max(1, PointsPerChunk / 2);

        /// <summary>The most points of tops in one merge of upper levels: more are merged in regions first.</summary>
        public long PointsPerRegion { get; private set; }

        /// <summary>Whether points go to temporary files because not all of them fit.</summary>
        public bool UsesTemporaryFiles { get; private set; }

        public long ReadBytes { get; private set; }

        /// <summary>The maximum in flight if fewer do not keep workers busy: the memory that is free until chunks are
        /// in progress.</summary>
        public long InFlightBytes => UsesTemporaryFiles ? ReadBytes : Math.Max(ReadBytes, IndexBytes);

        /// <summary>The most pages that chunks hold while sources are read, including those that wait to be written.</summary>
        public long MaxPages { get; private set; }
        public long MaxWaitingPages { get; private set; }

        public long IndexBytes { get; private set; }

        /// <summary>The most points that the first partition plans cubes for, if there would be too many to have a page
        /// each.</summary>
        public long MaxPointsPerPlannedCube { get; private set; }

        /// <summary>Bytes that a point takes while its chunk is indexed: number, node, what ranges offer, cube, priority, its
        /// record in both orders, and what is written of it; or before that, if all points are in one bucket, keys twice and its
        /// record once more.</summary>
        public long IndexBytesPerPoint { get; private set; }

        public long MinMemoryBytes => ChunkBytes / 9 * 10; // The least in which a chunk is indexed; less is exceeded by it.

        long ChunkBytes => Math.Min(Points, PointsPerChunk) * IndexBytesPerPoint;

        public long PlaceholderPoints { get; private set; } // Points of the sample that represents what is not built yet.

        /// <summary>See <see cref="ReadBytes"/>, which the sample before the plan keeps to as well.</summary>
        public static long ReadBytesOf(ConvertSettings settings) =>
            Math.Min(SourceScan.MaxSlotBytes, settings.MemoryBytes / 4);

        /// <param name="pointsPerChunk">If there is a plan for several builds.</param>
        public static MemoryPlan For(long points, int strideBytes, ConvertSettings settings, long pointsPerChunk = 0)
        {
            long memoryBytes = settings.MemoryBytes;
            pointsPerChunk = pointsPerChunk > 0 ? pointsPerChunk : settings.PointsPerChunk;
            long pageBytes = RecordPages.PageBytes(strideBytes);
            var plan = new MemoryPlan
            {
                Points = points,
                ReadBytes = ReadBytesOf(settings),
                IndexBytes = memoryBytes / 10 * 9,
                PointsPerChunk = pointsPerChunk,
                IndexBytesPerPoint = 41 + 3 * (long)strideBytes +
                    (settings.Sampler == Sampler.Random ? 0 : PoissonBytesPerPoint) +
                    (settings.Sampler == Sampler.Average ? AverageBytesPerPoint : 0),
            };
            if (pointsPerChunk <= 0)
            {
                plan.PointsPerChunk = Math.Max(MinPointsPerChunk, Math.Min(MaxPointsPerChunk, points / ChunksPerBaseCell));
                while (plan.PointsPerChunk > MinPointsOfLargeRecords &&
                    plan.PointsPerChunk * plan.IndexBytesPerPoint > MaxChunkBytes)
                    plan.PointsPerChunk /= 2;
            }
            plan.PointsPerRegion = settings.PointsPerRegion > 0 ? settings.PointsPerRegion
                : Math.Max(plan.PointsPerChunk, MinPointsPerRegion);
            plan.PointsPerBaseCell = ChunksPerBaseCell * (pointsPerChunk > 0 ? pointsPerChunk : MaxPointsPerChunk);

            plan.PlaceholderPoints = Math.Min(Math.Min(points, MaxPlaceholderPoints),
                memoryBytes / PlaceholderDivisor / plan.IndexBytesPerPoint);
            memoryBytes -= plan.PlaceholderPoints * plan.IndexBytesPerPoint;

            // This counts all records, the unused ends of their pages, the tops that come while the first chunks are indexed,
            // and one of these chunks.
            long inMemory = points * strideBytes / 10 * 11;
            long inWork = plan.ChunkBytes - Math.Min(points, plan.PointsPerChunk) * strideBytes;
            plan.UsesTemporaryFiles = inMemory + Math.Max(plan.ReadBytes, inWork) > memoryBytes;
            plan.MaxPages = plan.UsesTemporaryFiles
                ? Math.Max(8, (memoryBytes - plan.ReadBytes) * 2 / 3 / pageBytes) : long.MaxValue / 2;
            plan.MaxWaitingPages = Math.Max(4, plan.MaxPages / 4);
            if (!plan.UsesTemporaryFiles)
                plan.IndexBytes = Math.Max(0, memoryBytes - inMemory);
            // Half of the pages may be the chunks' last ones, which are not full; cubes are cut in eight.
            plan.MaxPointsPerPlannedCube = plan.UsesTemporaryFiles
                ? Math.Max(plan.PointsPerPlannedCube, 16 * (points / Math.Max(1, plan.MaxPages)))
                : plan.PointsPerPlannedCube;
            return plan;
        }
    }
}
