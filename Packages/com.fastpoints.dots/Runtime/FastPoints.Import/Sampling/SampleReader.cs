using System;
using System.Collections.Generic;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Sampling
{
    /// <summary>Presents a preview's sample as a source with an octree: one node, in blocks whose points are each spread over all
    /// of the sample. <c>TreeSource</c> can thus stream it like any cloud, before one is built.</summary>
    internal sealed class SampleReader : PointReader
    {
        public const int PointsPerBlock = 1 << 15;

        readonly int[] m_sharedReaderCount; // Number of readers of the same points; the last one frees them.
        bool m_isDisposed;

        /// <param name="points">All points of the sample, which this reader owns.</param>
        SampleReader(PreviewSample sample, PointBatch points, string path)
        {
            Points = points;
            HasAllPoints = sample.HasAllPoints;
            m_sharedReaderCount = new[] { 1 };
            int count = Points.Count;
            BlockCount = (count + PointsPerBlock - 1) / PointsPerBlock;
            var bounds = sample.Bounds.IsEmpty ? new BoundsGeo(0, 0) : sample.Bounds;
            Info = new SourceInfo
            {
                Path = path,
                Format = "sample",
                Schema = Points.Schema,
                Transform = sample.Transform,
                PointsClaimed = (ulong)count,
                PointsReadable = count,
                HasBoundsClaimed = !sample.Bounds.IsEmpty,
                BoundsClaimed = sample.Bounds,
            };
            double edge = math.max(math.cmax(bounds.Size), math.cmax(math.abs(sample.Transform.Scale)));
            // This assumes that the points of a block lie on a surface.
            double spacing = edge / math.sqrt(math.max(1.0, math.min(count, PointsPerBlock)));
            var cube = new BoundsGeo(bounds.Min, bounds.Min + edge);
            Tree = TreeOf(cube, spacing);
        }

        SampleReader(SampleReader other)
        {
            Points = other.Points;
            HasAllPoints = other.HasAllPoints;
            Info = other.Info;
            BlockCount = other.BlockCount;
            m_sharedReaderCount = other.m_sharedReaderCount;
            m_sharedReaderCount[0]++;
            Tree = TreeOf(other.Tree.Cube, other.Tree.Spacing);
        }

        public bool HasAllPoints { get; }

        internal PointBatch Points { get; }

        internal override SourceTree Tree { get; }
        public override int BlockCount { get; }
        public override int MaxPointsPerBlock => BlockCount == 0 ? 0 : PointsInBlock(0);

        public override int PointsInBlock(int block) => (Points.Count - block + BlockCount - 1) / BlockCount;

        public override long FirstPointOfBlock(int block)
        {
            // The first blocks have one point more than the others.
            int longer = Points.Count % BlockCount;
            return (long)block * (Points.Count / BlockCount) + Math.Min(block, longer);
        }

        public override long BytesOfRange(BlockRange range) => 0;

        public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator) =>
            new SampleRead(this, Points, wanted, capacity, allocator);

        /// <summary>Another reader of the same points; null if they were freed.</summary>
        internal SampleReader TryDuplicate() => Points.IsCreated ? new SampleReader(this) : null;

        public override void DisposeUnread()
        {
            if (m_isDisposed)
                return;
            m_isDisposed = true;
            Tree.Dispose();
            if (--m_sharedReaderCount[0] == 0)
                Points.Dispose();
        }

        /// <summary>Coroutine: copies a sample in jobs. The sample must not change before the work has ended.</summary>
        /// <param name="path">Path of the source, for messages.</param>
        /// <param name="copied">Receives the reader and owns it.</param>
        public static IEnumerator<JobStep> Copy(PreviewSample sample, string path, Action<SampleReader> copied)
        {
            var points = RoomFor(sample);
            JobHandle copying = default;
            bool isDone = false;
            try
            {
                foreach (var job in CopyJobs(sample, points))
                    copying = job.Schedule(copying);
                yield return copying;
                copying.Complete();
                isDone = true;
            }
            finally
            {
                copying.Complete();
                if (!isDone)
                    points.Dispose();
            }
            copied(new SampleReader(sample, points, path));
        }

        SourceTree TreeOf(BoundsGeo cube, double spacing)
        {
            var tree = new SourceTree(cube, spacing, Allocator.Persistent) { IsHierarchyRead = true };
            if (BlockCount == 0)
                tree.Add(new SourceNode { Block = -1 });
            for (int block = 0; block < BlockCount; block++)
                tree.Add(new SourceNode { Block = block, PointCount = PointsInBlock(block) });
            return tree;
        }

        static PointBatch RoomFor(PreviewSample sample) =>
            new PointBatch(sample.Points.Schema, Math.Max(1, sample.Count), Allocator.Persistent) { Count = sample.Count };

        static IEnumerable<CopyColumnJob> CopyJobs(PreviewSample sample, PointBatch to)
        {
            for (int c = 0; c < to.Schema.Count; c++)
            {
                int size = to.Schema[c].Type.SizeOf(), pointsOfSlice = CopyColumnJob.BytesOfSlice / size;
                for (int first = 0; first < to.Count; first += pointsOfSlice)
                    yield return new CopyColumnJob
                    {
                        From = sample.Points.Bytes,
                        To = to.Bytes,
                        FirstByteOfFrom = sample.Points.Column(c).OffsetBytes + first * size,
                        FirstByteOfTo = to.Column(c).OffsetBytes + first * size,
                        ByteCount = Math.Min(pointsOfSlice, to.Count - first) * size,
                    };
            }
        }
    }

    [BurstCompile]
    internal unsafe struct CopyColumnJob : IJob
    {
        public const int BytesOfSlice = 4 << 20; // A slice takes about 3 ms if the memory is touched for the first time.

        [ReadOnly] public NativeArray<byte> From;
        public NativeArray<byte> To;
        public int FirstByteOfFrom;
        public int FirstByteOfTo;
        public int ByteCount;

        public void Execute() => UnsafeUtility.MemCpy((byte*)To.GetUnsafePtr() + FirstByteOfTo,
            (byte*)From.GetUnsafeReadOnlyPtr() + FirstByteOfFrom, ByteCount);
    }

    sealed class SampleRead : BlockRead
    {
        readonly PointReader m_reader;
        readonly PointBatch m_sample;
        NativeArray<PointColumn> m_columns;

        /// <param name="sample">All points; a block has every n-th of them, where n is the number of blocks.</param>
        public SampleRead(PointReader reader, PointBatch sample, PointSchema wanted, int capacity, Allocator allocator)
        {
            m_reader = reader;
            m_sample = sample;
            Points = new PointBatch(wanted, capacity, allocator);
            Result = new NativeReference<DecodeResult>(allocator);
            m_columns = new NativeArray<PointColumn>(2 * wanted.Count, allocator);
            for (int c = 0; c < wanted.Count; c++)
            {
                m_columns[2 * c] = sample.Column(sample.Schema.IndexOf(wanted[c].Name));
                m_columns[2 * c + 1] = Points.Column(c);
            }
        }

        public override void Begin(BlockRange range)
        {
            Range = range;
            FirstPoint = m_reader.FirstPointOfBlock(range.Block) + range.First;
            Decoded = new CopyStrideJob
            {
                From = m_sample.Bytes,
                Columns = m_columns,
                To = Points.Bytes,
                Result = Result,
                First = range.Block + range.First * m_reader.BlockCount,
                Step = m_reader.BlockCount,
                Count = range.Count,
            }.Schedule();
        }

        public override void Complete()
        {
            Decoded.Complete();
            Points.Count = Result.Value.Points;
        }

        public override void Dispose()
        {
            if (!m_columns.IsCreated)
                return;
            Decoded.Complete();
            m_columns.Dispose();
            Points.Dispose();
            Result.Dispose();
        }
    }

    [BurstCompile]
    internal unsafe struct CopyStrideJob : IJob
    {
        [ReadOnly] public NativeArray<byte> From;
        [ReadOnly] public NativeArray<PointColumn> Columns; // Two numbers for each column: where it is, and where it goes.
        public NativeArray<byte> To;
        public NativeReference<DecodeResult> Result;
        public int First;
        public int Step;
        public int Count;

        public void Execute()
        {
            for (int c = 0; c < Columns.Length; c += 2)
            {
                int size = Columns[c].Type.SizeOf();
                byte* from = (byte*)From.GetUnsafeReadOnlyPtr() + Columns[c].OffsetBytes + (long)First * size;
                byte* to = (byte*)To.GetUnsafePtr() + Columns[c + 1].OffsetBytes;
                for (int i = 0; i < Count; i++, from += (long)Step * size, to += size)
                    UnsafeUtility.MemCpy(to, from, size);
            }
            Result.Value = new DecodeResult { Points = Count };
        }
    }
}
