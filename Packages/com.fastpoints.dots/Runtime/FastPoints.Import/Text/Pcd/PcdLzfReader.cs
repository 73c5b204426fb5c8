using System;
using System.Collections.Generic;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Text
{
    // A binary_compressed file: one LZF stream in which each field has the values of all points, field after field. One pass
    // decodes it and keeps a checkpoint where each block of points begins in each field, so that ranges are read alone and in any
    // order. The checkpoints take at most about 3 % of the decoded bytes, and 32 MB.
    sealed class PcdLzfReader : PointReader
    {
        const int DefaultBlockPoints = 65536, MaxBlockPoints = 1 << 20, MaxFieldBytes = 4 << 20, MaxCheckpoints = 4096;
        const int SizesBytes = 8;
        const int MaxInflation = 88; // A copy of 264 bytes takes 3: a small file cannot claim a large cloud.

        readonly PlyFile m_file;
        readonly PcdField[] m_fields;
        readonly long[] m_starts;
        readonly long m_decodedBytes;
        readonly int m_blockPoints;
        readonly int m_widestBytes = 1;
        NativeArray<LzfCheckpoint> m_checkpoints;
        NativeArray<byte> m_windows;
        long m_points = -1;

        public PcdLzfReader(RandomAccessFile source, PcdHeader header, PlyFile file)
        {
            Info = file.Info;
            m_file = file;
            m_fields = header.Fields.ToArray();
            var sizes = source.Read(header.DataOffset, SizesBytes, "sizes of the compressed points");
            StreamBytes = Math.Min(BitConverter.ToUInt32(sizes.Bytes, 0), source.Length - header.DataOffset - SizesBytes);
            StreamOffset = header.DataOffset + SizesBytes;
            m_decodedBytes = BitConverter.ToUInt32(sizes.Bytes, 4);
            int recordBytes = file.Vertex.FixedBytes;
            if ((ulong)m_decodedBytes / (ulong)recordBytes != header.Points || m_decodedBytes % recordBytes != 0)
                throw PointCloudException.Wanted(FailureCode.BadInput, source.Path, header.DataOffset + 4, "decompressed size",
                    NumberText.Of(header.Points) + " points of " + recordBytes + " bytes", NumberText.Of(m_decodedBytes));
            if (m_decodedBytes > StreamBytes * MaxInflation)
                throw PointCloudException.Wanted(FailureCode.Truncated, source.Path, StreamOffset, "compressed points",
                    "at least " + NumberText.Of(m_decodedBytes / MaxInflation) + " bytes", NumberText.Of(StreamBytes));
            m_starts = new long[m_fields.Length];
            for (int i = 0; i < m_fields.Length; i++)
            {
                m_starts[i] = i == 0 ? 0 : m_starts[i - 1] + (long)header.Points * m_fields[i - 1].Bytes;
                m_widestBytes = Math.Max(m_widestBytes, m_fields[i].Bytes);
            }
            m_blockPoints = Math.Max(1, Math.Min(DefaultBlockPoints, MaxFieldBytes / m_widestBytes));
            while (m_blockPoints < MaxBlockPoints && BlocksOf((long)header.Points) * m_fields.Length > MaxCheckpoints)
                m_blockPoints *= 2;
            if (header.Points == 0)
                m_points = Info.PointsReadable = 0;
        }

        public long StreamOffset { get; }
        public long StreamBytes { get; }
        public SourceHandle File => m_file.Handle;
        public NativeArray<byte> Windows => m_windows;
        public int MaxDecodedBytes => m_widestBytes * m_blockPoints;

        public override bool BlocksAreKnown => m_points >= 0;
        public override int BlockCount => (int)BlocksOf(FoundPoints());
        public override int MaxPointsPerBlock => (int)Math.Min(m_blockPoints, FoundPoints());

        long BlocksOf(long points) => (points + m_blockPoints - 1) / m_blockPoints;

        long FoundPoints() => m_points >= 0 ? m_points : throw new InvalidOperationException("FindBlocks comes first");

        public override long FirstPointOfBlock(int block) => (long)block * m_blockPoints;

        public override int PointsInBlock(int block) => (int)Math.Min(m_blockPoints, FoundPoints() - FirstPointOfBlock(block));

        public override long BytesOfRange(BlockRange range)
        {
            long bytes = 0;
            for (int field = 0; range.Count > 0 && field < m_fields.Length; field++)
                bytes += SegmentOf(field, range.Block, out _).Bytes;
            return bytes;
        }

        // offset: in the file.
        public LzfSegment SegmentOf(int field, int block, out long offset)
        {
            int index = field * (int)BlocksOf((long)Info.PointsClaimed) + block;
            var checkpoint = m_checkpoints[index];
            // The shortest copy takes two bytes and writes three: twice the wanted length is always enough.
            long end = Math.Min(StreamBytes, checkpoint.Input + Lzf.MaxRead
                + 2 * (checkpoint.Skip + (long)m_blockPoints * m_fields[field].Bytes));
            if (index + 1 < m_checkpoints.Length && m_checkpoints[index + 1].Input > 0)
                end = Math.Min(end, m_checkpoints[index + 1].Input + Lzf.MaxRead);
            offset = StreamOffset + checkpoint.Input;
            return new LzfSegment
            {
                Bytes = (int)(end - checkpoint.Input),
                Checkpoint = index,
                Skip = checkpoint.Skip,
                FieldBytes = m_fields[field].Bytes,
            };
        }

        public override IEnumerator<JobStep> FindBlocks()
        {
            if (BlocksAreKnown)
                yield break;
            DisposeUnread();
            var state = new NativeReference<LzfWalk>(Allocator.Persistent);
            var buffer = new NativeArray<byte>(WalkLzfJob.BufferBytes, Allocator.Persistent);
            var offsets = new NativeArray<long>(OffsetsOfCheckpoints(), Allocator.Persistent);
            m_checkpoints = new NativeArray<LzfCheckpoint>(offsets.Length, Allocator.Persistent);
            m_windows = new NativeArray<byte>(offsets.Length * Lzf.WindowBytes, Allocator.Persistent);
            var read = new NativeFileRead(Math.Min(StreamBytes, WalkLzfJob.SliceBytes), Allocator.Persistent);
            var walked = default(JobHandle);
            try
            {
                while (state.Value.Output < m_decodedBytes && !state.Value.IsBroken)
                {
                    long at = state.Value.Input;
                    int bytes = (int)Math.Min(StreamBytes - at, WalkLzfJob.SliceBytes);
                    while (!read.TryFetch(File.Path, StreamOffset + at, bytes))
                        yield return default;
                    walked = new WalkLzfJob
                    {
                        Input = read.Buffer,
                        InputBytes = bytes,
                        DecodedBytes = m_decodedBytes,
                        Buffer = buffer,
                        Offsets = offsets,
                        Checkpoints = m_checkpoints,
                        Windows = m_windows,
                        State = state,
                    }.Schedule(read.Begin(File, StreamOffset + at, bytes));
                    yield return walked;
                    walked.Complete();
                    read.End();
                }
                CountPoints(state.Value);
            }
            finally
            {
                walked.Complete();
                read.Dispose();
                offsets.Dispose();
                buffer.Dispose();
                state.Dispose();
            }
        }

        long[] OffsetsOfCheckpoints()
        {
            int blocks = (int)BlocksOf((long)Info.PointsClaimed);
            var offsets = new long[blocks * m_fields.Length];
            for (int i = 0; i < offsets.Length; i++)
                offsets[i] = m_starts[i / blocks] + i % blocks * (long)m_blockPoints * m_fields[i / blocks].Bytes;
            return offsets;
        }

        // A truncated stream leaves the points whose last field is complete.
        void CountPoints(LzfWalk end)
        {
            int last = m_fields.Length - 1;
            while (m_fields[last].Bytes == 0)
                last--;
            long points = Math.Max(0, (end.Output - m_starts[last]) / m_fields[last].Bytes);
            m_file.SetPointCount(points, StreamOffset + end.Input, "the compressed stream " +
                (end.Input >= StreamBytes ? "ends" : "is damaged") + " here, and the values of a field follow one another");
            m_points = points;
        }

        public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator)
        {
            FoundPoints();
            return new PcdLzfRead(this, wanted, capacity, allocator);
        }

        public List<(int Field, FieldCopy[] Copies)> PlanFor(PointBatch batch)
        {
            var plan = new List<(int, FieldCopy[])>();
            int property = 0;
            for (int i = 0; i < m_fields.Length; i++)
            {
                var fields = new List<PointField>();
                var columns = new List<PointColumn>();
                for (int j = 0; j < m_fields[i].Count; j++, property++)
                    foreach (var field in m_file.FieldsOf(property, j * m_fields[i].Type.SizeOf()))
                    {
                        int column = batch.Schema.IndexOf(field.Name);
                        if (column < 0)
                            continue;
                        fields.Add(field);
                        columns.Add(batch.Column(column));
                    }
                if (fields.Count > 0)
                    plan.Add((i, FieldCopyPlan.Make(fields.ToArray(), columns.ToArray())));
            }
            return plan;
        }

        internal override void ListPieces(BlockRange range, List<FilePiece> pieces)
        {
            for (int field = 0; field < m_fields.Length; field++)
            {
                int bytes = SegmentOf(field, range.Block, out long offset).Bytes;
                pieces.Add(new FilePiece { Path = File.Path, OffsetBytes = offset, LengthBytes = bytes });
            }
        }

        public override void CloseFile() => File.Close();

        public override void DisposeUnread()
        {
            if (m_windows.IsCreated)
                m_windows.Dispose();
            if (m_checkpoints.IsCreated)
                m_checkpoints.Dispose();
        }
    }

    sealed unsafe class PcdLzfRead : SlotRead
    {
        readonly PcdLzfReader m_reader;
        readonly List<(int Field, FieldCopy[] Copies)> m_plan;
        readonly NativeArray<FieldCopy> m_copies;
        readonly NativeArray<byte> m_buffer;
        NativeArray<LzfSegment> m_segments;

        public PcdLzfRead(PcdLzfReader reader, PointSchema wanted, int capacity, Allocator allocator)
            : base(reader, wanted, capacity, allocator)
        {
            m_reader = reader;
            m_plan = reader.PlanFor(Points);
            long max = 0;
            for (int block = 0; block < reader.BlockCount; block++)
            {
                long bytes = 0;
                foreach (var (field, _) in m_plan)
                    bytes += reader.SegmentOf(field, block, out _).Bytes;
                max = Math.Max(max, bytes);
            }
            var copies = new List<FieldCopy>();
            foreach (var (_, ofField) in m_plan)
                copies.AddRange(ofField);
            OwnFile(max, allocator, m_plan.Count);
            m_segments = OwnArray<LzfSegment>(m_plan.Count, allocator, NativeArrayOptions.ClearMemory);
            m_copies = Own(new NativeArray<FieldCopy>(copies.ToArray(), allocator));
            m_buffer = OwnArray<byte>(Lzf.WindowBytes + reader.MaxDecodedBytes + 2 * Lzf.MaxWritten, allocator,
                NativeArrayOptions.ClearMemory);
        }

        protected override JobHandle Schedule(BlockRange range)
        {
            var commands = File.Commands;
            byte* buffer = (byte*)File.Buffer.GetUnsafePtr();
            int used = 0, copies = 0;
            for (int i = 0; i < m_plan.Count; i++)
            {
                var segment = m_reader.SegmentOf(m_plan[i].Field, range.Block, out long offset);
                segment.FirstByte = used;
                segment.FirstCopy = copies;
                segment.Copies = m_plan[i].Copies.Length;
                m_segments[i] = segment;
                commands[i] = new ReadCommand { Buffer = buffer + used, Offset = offset, Size = segment.Bytes };
                used += segment.Bytes;
                copies += segment.Copies;
            }
            return new DecodeLzfJob
            {
                Input = File.Buffer,
                Segments = m_segments,
                Copies = m_copies,
                Windows = m_reader.Windows,
                Buffer = m_buffer,
                First = range.First,
                Count = range.Count,
                Columns = Points.Bytes,
                Result = Result,
            }.Schedule(DependencyOf(File.Begin(m_reader.File, m_plan.Count)));
        }

        protected override void Warn(DecodeResult result)
        {
            if (result.Error != 0)
                throw new PointCloudException(FailureCode.ReadFailed, m_reader.Info.Path, m_reader.StreamOffset,
                    "the compressed points are not those that were found: the file has changed");
        }
    }
}
