using System;
using FastPoints.Records;
using FastPoints.Samplers;

namespace FastPoints.Convert
{
    /// <summary>
    /// What a build's memory is divided into. Chunks, and with them the stored bytes, depend on the number of points, the bytes
    /// of
    /// a record and the memory that was allowed: not on how many threads there are.
    /// </summary>
    internal sealed class MemoryPlan
    {
        const long MaxPointsPerChunk = 1000000;

        // A chunk that a sample or a cube's octants made eight times smaller is still more than one leaf.
        const long MinPointsPerChunk = 200000;

        /// <summary>However little memory there is: smaller chunks would be nothing but tops.</summary>
        const long LeastPointsPerChunk = 1 << 16;

        const int ChunksPlanned = 2;

        /// <summary>More show no more in a picture of everything; fewer where they took more than this share of the
        /// memory.</summary>
        const long MaxProvisionalPoints = 1 << 17;
        const long ProvisionalShare = 16;

        /// <summary>Darts, samples and their grid.</summary>
        const int PoissonBytesPerPoint = 40;

        /// <summary>Which sum a point adds to; the sums of a third of the points, in a list that grows by doubling; and the plane
        /// of colours and intensities that is written of them.</summary>
        const int AverageBytesPerPoint = 4 + 28 + 8;

        MemoryPlan()
        {
        }

        /// <summary>Chunks are made for so many points, and have at most twice as many.</summary>
        public long PointsPerChunk { get; private set; }

        /// <summary>Whether points go to temporary files: not all of them fit.</summary>
        public bool IsStored { get; private set; }

        /// <summary>Bytes of the blocks in flight while sources are read.</summary>
        public long ReadBytes { get; private set; }

        /// <summary>Pages that chunks hold while sources are read, and that wait to be written at most.</summary>
        public long MostPages { get; private set; }
        public long MostWaitingPages { get; private set; }

        /// <summary>Bytes for chunks in work, and for the upper levels' merge.</summary>
        public long IndexBytes { get; private set; }

        /// <summary>Points that the first partition makes chunks for: more where there would be too many to have a page
        /// each.</summary>
        public long PointsPerPartition { get; private set; }

        /// <summary>Bytes that a point takes while its chunk is in work: keys twice, order, node, cube, priority and number, its
        /// record as it came and in order, and what is written of it.</summary>
        public long IndexBytesPerPoint { get; private set; }

        /// <summary>Points of the sample that stands for what is not built yet.</summary>
        public long ProvisionalPoints { get; private set; }

        /// <param name="points">Of all sources, at most.</param>
        public static MemoryPlan For(long points, int strideBytes, ConvertSettings settings)
        {
            long pointsPerChunk = settings.PointsPerChunk, memoryBytes = settings.MemoryBytes;
            long pageBytes = RecordPages.PageBytes(strideBytes);
            var plan = new MemoryPlan
            {
                ReadBytes = Math.Min(Files.SourceScan.MaxSlotBytes, memoryBytes / 4),
                IndexBytes = memoryBytes / 10 * 9,
                PointsPerChunk = pointsPerChunk,
                IndexBytesPerPoint = 37 + 3 * (long)strideBytes +
                    (settings.Sampler == Sampler.Random ? 0 : PoissonBytesPerPoint) +
                    (settings.Sampler == Sampler.Average ? AverageBytesPerPoint : 0),
            };
            if (pointsPerChunk <= 0)
            {
                plan.PointsPerChunk = Math.Max(MinPointsPerChunk, Math.Min(MaxPointsPerChunk, points / 16));
                // Halves, so that about the same memory gives the very same chunks.
                long most = MaxPointsPerChunk;
                while (most > LeastPointsPerChunk && 2 * most * ChunksPlanned * plan.IndexBytesPerPoint > memoryBytes / 4 * 3)
                    most /= 2;
                plan.PointsPerChunk = Math.Min(plan.PointsPerChunk, most);
            }

            plan.ProvisionalPoints = Math.Min(Math.Min(points, MaxProvisionalPoints),
                memoryBytes / ProvisionalShare / plan.IndexBytesPerPoint);
            memoryBytes -= plan.ProvisionalPoints * plan.IndexBytesPerPoint;

            // All records, their pages' unused ends, the tops that come while the first chunks are in work, and one of these.
            long inMemory = points * strideBytes / 10 * 11;
            long oneChunk = Math.Min(points, 2 * plan.PointsPerChunk) * (plan.IndexBytesPerPoint - strideBytes);
            plan.IsStored = inMemory + Math.Max(oneChunk, plan.ReadBytes) > memoryBytes;
            plan.MostPages = plan.IsStored ? Math.Max(8, (memoryBytes - plan.ReadBytes) / 2 / pageBytes) : long.MaxValue / 2;
            plan.MostWaitingPages = Math.Max(4, plan.MostPages / 4);
            if (!plan.IsStored)
                plan.IndexBytes = Math.Max(0, memoryBytes - inMemory);
            // Half of the pages may be the chunks' last ones, which are not full; cubes are cut in eight.
            plan.PointsPerPartition = plan.IsStored
                ? Math.Max(plan.PointsPerChunk, 16 * (points / Math.Max(1, plan.MostPages)))
                : plan.PointsPerChunk;
            return plan;
        }
    }
}
