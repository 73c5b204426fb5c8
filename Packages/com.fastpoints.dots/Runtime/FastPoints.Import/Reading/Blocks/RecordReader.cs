using System;
using System.Collections.Generic;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Reading
{
    sealed class FixedRecords
    {
        public readonly SourceHandle File;
        public readonly PointFields Fields;
        public readonly long DataOffset;
        public readonly int RecordBytes;
        public readonly bool IsBigEndian;

        public FixedRecords(SourceHandle file, PointFields fields, long dataOffset, int recordBytes, bool isBigEndian = false)
        {
            File = file;
            Fields = fields;
            DataOffset = dataOffset;
            RecordBytes = recordBytes;
            IsBigEndian = isBigEndian;
        }

        public long OffsetOf(long point) => DataOffset + point * RecordBytes;

        public NativeArray<FieldCopy> CopiesTo(PointBatch batch, Allocator allocator) =>
            new NativeArray<FieldCopy>(FieldCopyPlan.Make(Fields, batch, IsBigEndian), allocator);
    }

    // Blocks of one number of points, but the last: records of one length, any of which can be read alone, or as strided ranges.
    internal abstract class RecordReader : PointReader
    {
        // Measured beside 16,384 and 65,536: blocks in flight stay in the caches, and there are not too many of them.
        const int MaxBlockPoints = 32768;
        const int MaxBlockBytes = 4 << 20; // Records of many fields come in shorter blocks, so that a slot's memory stays small.

        readonly SourceHandle m_file;
        readonly int m_blockPoints;
        readonly int m_recordBytes;
        FixedRecords m_records;
        long m_points;

        private protected RecordReader(SourceInfo info, SourceHandle file, int recordBytes)
        {
            Info = info;
            m_file = file;
            m_recordBytes = recordBytes;
            m_blockPoints = Math.Max(1, Math.Min(MaxBlockPoints, MaxBlockBytes / recordBytes));
        }

        private protected void SetRecords(PointFields fields, long dataOffset, bool isBigEndian, long points)
        {
            if ((points + m_blockPoints - 1) / m_blockPoints > int.MaxValue)
                throw PointCloudException.Wanted(FailureCode.Unsupported, Info.Path, -1, "points",
                    "at most " + (long)int.MaxValue * m_blockPoints, points);
            m_records = new FixedRecords(m_file, fields, dataOffset, m_recordBytes, isBigEndian);
            m_points = points;
        }

        FixedRecords Records => m_records ?? throw new InvalidOperationException("IndexBlocks comes first");

        long Points => Records == null ? 0 : m_points;

        public sealed override bool BlocksAreKnown => m_records != null;
        public sealed override bool HasCheapRanges => true;
        public sealed override int BlockCount => (int)((Points + m_blockPoints - 1) / m_blockPoints);
        public sealed override int MaxPointsPerBlock => (int)Math.Min(m_blockPoints, Points);

        public sealed override long FirstPointOfBlock(int block) => (uint)block < (uint)BlockCount ? (long)block * m_blockPoints
            : throw new ArgumentOutOfRangeException(nameof(block), block, "the source has " + BlockCount + " blocks");

        public sealed override int PointsInBlock(int block) => (int)Math.Min(m_blockPoints, m_points - FirstPointOfBlock(block));

        public sealed override long BytesOfRange(BlockRange range) => (long)range.Count * m_recordBytes;

        internal sealed override void ListPieces(BlockRange range, List<FilePiece> pieces) => pieces.Add(PieceOf(
            new StridedRange { First = FirstPointOfBlock(range.Block) + range.First, Step = 1, Count = range.Count }));

        internal FilePiece PieceOf(in StridedRange range) => new FilePiece
        {
            Path = m_file.Path,
            OffsetBytes = Records.OffsetOf(range.First),
            LengthBytes = StridedRead.BytesOf(range, m_recordBytes),
        };

        // Fetches strided ranges in advance, so many a read, with what lies between them; null for a local file.
        internal FetchWindow WindowOf(NativeArray<StridedRange> ranges, int perRead) => !IsRemote ? null
            : new FetchWindow(0, (ranges.Length + perRead - 1) / perRead, (read, pieces) =>
            {
                var piece = PieceOf(ranges[read * perRead]);
                var last = PieceOf(ranges[Math.Min(ranges.Length, (read + 1) * perRead) - 1]);
                piece.LengthBytes = last.OffsetBytes + last.LengthBytes - piece.OffsetBytes;
                pieces.Add(piece);
            });

        public sealed override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator) =>
            new RecordRead(this, Records, wanted, capacity, allocator);

        // A slot for strided ranges: maxRanges and maxBytes are of one request; these bytes are at least those of the longest
        // range.
        public StridedRead CreateStridedRead(PointBatch target, int maxRanges, int maxBytes, Allocator allocator) =>
            new StridedRead(Records, target, maxRanges, maxBytes, allocator);

        public sealed override void CloseFile() => m_file.Close();

        // Coroutine: reads ranges of points, in the file's order, into a batch, one after the other. "then" schedules jobs that
        // need all ranges, after the given dependency; they are complete in the end.
        public IEnumerator<JobStep> ReadRanges(IReadOnlyList<BlockRange> ranges, int first, int count, PointBatch target,
            Func<JobHandle, JobHandle> then)
        {
            const int Slots = 8, BytesPerRequest = 2 << 20;
            int rangesPerRequest = TakesFewRanges ? 1 : 256;
            var strided = new NativeArray<StridedRange>(count, Allocator.Persistent);
            var reads = new StridedRead[Slots];
            var ring = new SlotRing(Slots);
            var decoded = default(JobHandle);
            FetchWindow window = null;
            try
            {
                int index = 0, longest = 1;
                for (int i = 0; i < count; i++)
                {
                    var range = ranges[first + i];
                    long from = FirstPointOfBlock(range.Block) + range.First;
                    strided[i] = new StridedRange { First = from, Step = 1, Count = range.Count, FirstInSample = index };
                    index += range.Count;
                    longest = Math.Max(longest, range.Count);
                }
                if (count == 0)
                    decoded = then(default);
                window = WindowOf(strided, rangesPerRequest);
                for (int next = 0; next < count || !ring.IsEmpty;)
                {
                    if (next == count || ring.IsFull)
                    {
                        yield return reads[ring.Oldest].Decoded;
                        reads[ring.End()].Complete();
                        continue;
                    }
                    while (window != null && !window.TryPrepareNext())
                        yield return default;
                    int slot = ring.Begin();
                    reads[slot] ??= CreateStridedRead(target, rangesPerRequest,
                        Math.Max(BytesPerRequest, longest * m_recordBytes * (IsRemote ? rangesPerRequest : 1)),
                        Allocator.Persistent);
                    reads[slot].Fetched = window?.Take();
                    next += reads[slot].Begin(strided, next, rangesPerRequest, 0);
                    decoded = JobHandle.CombineDependencies(decoded, reads[slot].Decoded);
                    if (next == count)
                        decoded = then(decoded);
                    JobHandle.ScheduleBatchedJobs();
                    // Lets JobCoroutine check its budget.
                    yield return default;
                }
                yield return decoded;
            }
            finally
            {
                decoded.Complete();
                window?.Dispose();
                foreach (var read in reads)
                    read?.Dispose();
                strided.Dispose();
            }
        }
    }

    sealed class RecordRead : OwningBlockRead
    {
        readonly FixedRecords m_records;
        readonly NativeArray<FieldCopy> m_copies;

        public RecordRead(PointReader reader, FixedRecords records, PointSchema wanted, int capacity, Allocator allocator)
            : base(reader, wanted, CheckCapacity(records, capacity), allocator)
        {
            m_records = records;
            m_copies = Own(records.CopiesTo(Points, allocator));
            OwnFile((long)capacity * records.RecordBytes, allocator);
        }

        static int CheckCapacity(FixedRecords records, int capacity) =>
            capacity >= 0 && (long)capacity * records.RecordBytes <= int.MaxValue - NativeFileRead.PaddingBytes
                ? capacity
                : throw new ArgumentOutOfRangeException(nameof(capacity), capacity, "a slot holds at most 2 GiB of records");

        protected override JobHandle Schedule(BlockRange range) => new DecodeRecordsJob
        {
            Records = FileRead.Buffer,
            Copies = m_copies,
            Columns = Points.Bytes,
            Result = Result,
            RecordBytes = m_records.RecordBytes,
            Count = range.Count,
        }.Schedule(DependencyOf(FileRead.Begin(m_records.File, m_records.OffsetOf(FirstPoint),
            range.Count * m_records.RecordBytes)));

        protected override void Cancel() => FileRead.Cancel();

        // The header's claims were checked against the file's size at opening: a short read means that the file has changed
        // since, an error, not a cloud with fewer points.
        protected override void EndRead()
        {
            var status = FileRead.Close(out long got);
            if (status == ReadStatus.Complete)
                return;
            var result = Result;
            result.Value = default;
            bool isShort = status == ReadStatus.Truncated;
            throw PointCloudException.Wanted(isShort ? FailureCode.Truncated : FailureCode.ReadFailed, m_records.File.Path,
                FileRead.Offset, isShort ? "the file became shorter" : "the read failed", NumberText.Of(Range.Count) +
                " points of " + NumberText.Of(m_records.RecordBytes) + " bytes", NumberText.Of(got / m_records.RecordBytes));
        }
    }

    [BurstCompile]
    internal struct DecodeRecordsJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Records;
        [ReadOnly] public NativeArray<FieldCopy> Copies;
        public NativeArray<byte> Columns;
        public NativeReference<DecodeResult> Result;
        public int RecordBytes;
        public int Count;

        public unsafe void Execute()
        {
            PointRecords.ToColumns((byte*)Records.GetUnsafeReadOnlyPtr(), RecordBytes, Count, Copies,
                (byte*)Columns.GetUnsafePtr());
            Result.Value = new DecodeResult { Points = Count };
        }
    }
}
