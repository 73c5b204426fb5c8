using System;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Laz
{
    // Plans the reads that bring a layered chunk's wanted layers behind its header, packed as LayeredChunk.Start expects them:
    // neighbours in one read, and of each no more than the points take.
    [BurstCompile]
    internal unsafe struct PlanLazReadsJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Input; // The chunk's header, at its start.
        [ReadOnly] public NativeArray<int> BytesPerPoint; // Of each layer; 0 for one that is not wanted.

        // At most one for each wanted layer, or one of a single byte if there is nothing to read.
        public NativeArray<ReadCommand> Commands;
        public NativeArray<ReadCommandArray> CommandArray; // One value, whose count is set.

        public NativeArray<long> InputBytes;

        // The input's memory, which no job touches until the reads are done.
        [NativeDisableUnsafePtrRestriction] public byte* Buffer;

        public long BufferBytes;
        public int RecordBytes;
        public long ChunkOffset;
        public long ChunkEnd;
        public long Points;

        public void Execute()
        {
            byte* sizes = (byte*)Input.GetUnsafeReadOnlyPtr() + RecordBytes + 4;
            long headerBytes = LazLayer.ChunkHeaderBytes(RecordBytes, BytesPerPoint.Length);
            long inFile = ChunkOffset + headerBytes;
            long inBuffer = headerBytes < ChunkEnd - ChunkOffset ? headerBytes : ChunkEnd - ChunkOffset;
            int count = 0;
            for (int i = 0; i < BytesPerPoint.Length && inFile < ChunkEnd; i++)
            {
                long bytes = *(uint*)(sizes + 4 * i);
                if (BytesPerPoint[i] != 0)
                {
                    long enough = LazLayer.StartBytes + BytesPerPoint[i] * Points;
                    long read = bytes < enough ? bytes : enough;
                    // A size that exceeds the file or the buffer is wrong, and so is everything behind it.
                    bool isCut = read > ChunkEnd - inFile || read > BufferBytes - inBuffer;
                    if (isCut)
                        read = Min(ChunkEnd - inFile, BufferBytes - inBuffer);
                    if (read > 0)
                    {
                        Add(ref count, inFile, inBuffer, read);
                        inBuffer += read;
                    }
                    if (isCut)
                        break;
                }
                inFile += bytes;
            }
            InputBytes[0] = inBuffer;
            if (count == 0)
                Add(ref count, ChunkOffset, 0, 1);
            var array = CommandArray[0];
            array.CommandCount = count;
            CommandArray[0] = array;
        }

        void Add(ref int count, long inFile, long inBuffer, long bytes)
        {
            if (count > 0 && Commands[count - 1].Offset + Commands[count - 1].Size == inFile)
            {
                var longer = Commands[count - 1];
                longer.Size += bytes;
                Commands[count - 1] = longer;
                return;
            }
            Commands[count++] = new ReadCommand { Buffer = Buffer + inBuffer, Offset = inFile, Size = bytes };
        }

        static long Min(long a, long b)
        {
            long min = a < b ? a : b;
            return min > 0 ? min : 0;
        }
    }

    // Of a layered chunk only the wanted layers: first the header that says where they are, then a read that a job has planned.
    sealed unsafe class LazBlockRead : SlotRead
    {
        const int PointsPerSlice = 16384; // About 4 ms of decoding on one core.

        const int MaxBatchBytes = 64 << 10;

        // Layered chunks up to this size are read whole: two reads in sequence cost more than the bytes saved.
        const int SmallChunkBytes = 16 << 10;

        const int ExtraPadding = RangeCoder.PaddingBytes - NativeFileRead.PaddingBytes;

        readonly LazBlocks m_blocks;
        readonly LazFormat m_format;
        readonly int m_batchPoints;
        readonly bool m_needsAllLayers;
        NativeArray<byte> m_state;
        NativeArray<byte> m_batchRecords;
        NativeArray<FieldCopy> m_copies;
        NativeArray<int> m_bytesPerPoint;
        NativeArray<long> m_inputBytes;
        // The read manager keeps pointers to commands until their read has ended.
        NativeArray<ReadCommand> m_plannedCommands;
        NativeArray<ReadCommandArray> m_plannedArray;
        ReadHandle m_plannedRead;
        bool m_isPlanned;
        bool m_keepsStates;
        JobHandle m_copied;
        LazCheckpoint m_from; // What the range continues from; null for none.

        long m_inputOffset;

        public LazBlockRead(PointReader reader, LazBlocks blocks, PointSchema wanted, int capacity, Allocator allocator)
            : base(reader, wanted, capacity, allocator)
        {
            m_blocks = blocks;
            m_format = blocks.Format;
            m_batchPoints = Math.Max(1, Math.Min(LayeredChunk.BatchPoints, MaxBatchBytes / m_format.RecordBytes));
            m_copies = Own(new NativeArray<FieldCopy>(FieldCopyPlan.Make(blocks.Las.Layout.Fields, Points), allocator));
            m_needsAllLayers = ConfigureState(wanted, allocator);
            long inputBytes = Math.Max(blocks.MaxInputBytes(), SmallChunkBytes);
            OwnFile(inputBytes + ExtraPadding, allocator);
            m_batchRecords = OwnArray<byte>(Math.Max(1, m_batchPoints * m_format.RecordBytes), allocator);
            m_inputBytes = OwnArray<long>(1, allocator, NativeArrayOptions.ClearMemory);
            m_plannedCommands = Own(new NativeArray<ReadCommand>(Math.Max(1, m_format.Layers.Length), allocator));
            m_plannedArray = Own(new NativeArray<ReadCommandArray>(1, allocator));
        }

        bool ConfigureState(PointSchema wanted, Allocator allocator)
        {
            var layers = m_format.Layers;
            m_bytesPerPoint = OwnArray<int>(Math.Max(1, layers.Length), allocator, NativeArrayOptions.ClearMemory);
            var isWanted = m_format.IsLayered ? LazLayerChoice.Choose(layers, m_blocks.Las.Layout.Fields, wanted) : null;
            m_state = Own(m_format.CreateDecoder(isWanted, allocator));
            for (int i = 0; m_format.IsLayered && i < layers.Length; i++)
                m_bytesPerPoint[i] = isWanted[i] ? layers[i].MaxInputBytesPerPoint : 0;
            return isWanted == null || Array.TrueForAll(isWanted, layer => layer);
        }

        public override bool TryEnableStates() => m_keepsStates = true;

        internal override DecoderState KeepState(DecoderState reused)
        {
            if (!m_keepsStates || IsBusy || Points.Count < Range.Count)
                throw new InvalidOperationException("there is no state to go on from");
            var state = (LazCheckpoint)reused ?? new LazCheckpoint();
            state.Point = m_blocks[Range.Block].FirstInChunk + Range.First + Range.Count;
            state.FileOffset = m_inputOffset;
            if (!m_format.IsLayered)
            {
                var chunk = (PointwiseChunk*)m_state.GetUnsafePtr();
                state.FileOffset += chunk->InputOffset;
                PointwiseChunk.Rebase(chunk);
            }
            m_copied = state.Save(m_state, m_copied);
            return state;
        }

        internal override void Begin(BlockRange range, DecoderState from)
        {
            m_from = (LazCheckpoint)from;
            try
            {
                Begin(range);
            }
            finally
            {
                m_from = null;
            }
        }

        protected override JobHandle Schedule(BlockRange range)
        {
            var block = m_blocks[range.Block];
            if (block.FirstInChunk > 0 && block.FirstInChunk + range.First >= m_blocks.EndOfChunk(block))
                return default;

            var checkpoint = m_from ?? m_blocks.CheckpointOf(block);
            if (checkpoint != null && checkpoint.Point > block.FirstInChunk + range.First)
                throw new ArgumentException("the state is of points behind the range");
            if (checkpoint != null)
                m_copied = checkpoint.Restore(m_state, m_copied);
            long start = m_inputOffset = checkpoint?.FileOffset ?? m_blocks.ChunkOf(block).Offset;
            long skip = block.FirstInChunk - (checkpoint?.Point ?? 0) + range.First;
            // Streams of layers are offsets in the input, which is the same for every range that continues another.
            long inputPoints = m_format.IsLayered && m_keepsStates ? block.FirstInChunk + block.Points : skip + range.Count;
            // Blocks may be found after the slot was made: pages of a hierarchy are read as they are wanted.
            File.Reserve((IsWholeChunk ? block.EndOffset - start
                : Math.Min(block.EndOffset - start, m_blocks.MaxInputBytes(inputPoints))) + ExtraPadding);
            var decode = new DecodeLazJob
            {
                Input = File.Buffer,
                InputBytes = m_inputBytes,
                State = m_state,
                BatchRecords = m_batchRecords,
                Copies = m_copies,
                Columns = Points.Bytes,
                Result = Result,
                RecordBytes = m_format.RecordBytes,
                BatchPoints = m_batchPoints,
                IsLayered = m_format.IsLayered,
                HasAllLayers = true,
                IsContinued = checkpoint != null,
                Skip = checked((int)skip),
                Total = checked((int)(skip + range.Count)),
                InputPoints = inputPoints,
                ChunkPoints = m_blocks.ChunkOf(block).Points,
                ChunkBytes = m_blocks.ChunkOf(block).Bytes,
                FileOffset = start,
            };
            var read = Read(block, start, ref decode);
            return Schedule(decode, JobHandle.CombineDependencies(read, m_copied));
        }

        // A second request would cost more than the bytes saved.
        bool IsWholeChunk => m_format.IsLayered && m_blocks.File.IsRemote;

        JobHandle Read(LazBlock block, long start, ref DecodeLazJob decode)
        {
            long bytes = block.EndOffset - start;
            long max = m_blocks.MaxInputBytes(decode.InputPoints);
            if (!m_format.IsLayered)
            {
                bool isToEnd = block.IsToEnd && Range.First + Range.Count == block.Points;
                decode.IsToEnd = isToEnd && bytes <= max && m_format.Compressor != LazCompressor.Pointwise;
                return Read(start, Math.Min(bytes, max));
            }
            bool isWhole = block.IsToEnd && decode.InputPoints == block.FirstInChunk + block.Points;
            if (bytes <= SmallChunkBytes || IsWholeChunk || m_needsAllLayers && isWhole && bytes <= max)
                return Read(start, bytes);

            decode.HasAllLayers = false;
            var header = Read(start, Math.Min(bytes, LazLayer.ChunkHeaderBytes(m_format.RecordBytes, m_format.Layers.Length)));
            m_plannedArray[0] = new ReadCommandArray { ReadCommands = (ReadCommand*)m_plannedCommands.GetUnsafePtr() };
            var commands = (ReadCommandArray*)m_plannedArray.GetUnsafePtr();
            var planned = new PlanLazReadsJob
            {
                Input = File.Buffer,
                BytesPerPoint = m_bytesPerPoint,
                Commands = m_plannedCommands,
                CommandArray = m_plannedArray,
                InputBytes = m_inputBytes,
                Buffer = (byte*)File.Buffer.GetUnsafePtr(),
                BufferBytes = File.Buffer.Length - RangeCoder.PaddingBytes,
                RecordBytes = m_format.RecordBytes,
                ChunkOffset = start,
                ChunkEnd = block.EndOffset,
                Points = decode.InputPoints,
            }.Schedule(header);
            // The plan is made behind a read of the same handle, so that the file is open by then.
            m_plannedRead = AsyncReadManager.ReadDeferred(m_blocks.File.Open(), commands, planned);
            m_isPlanned = true;
            // The read follows the plan, but its handle does not promise to include it.
            return DependencyOf(JobHandle.CombineDependencies(planned, m_plannedRead.JobHandle));
        }

        JobHandle Read(long offset, long bytes)
        {
            m_inputBytes[0] = bytes;
            return DependencyOf(File.Begin(m_blocks.File, offset, (int)bytes));
        }

        static JobHandle Schedule(DecodeLazJob decode, JobHandle dependency)
        {
            for (int first = 0; first < decode.Total; first += PointsPerSlice)
            {
                decode.IsFirst = first == 0;
                decode.First = first;
                decode.Count = Math.Min(PointsPerSlice, decode.Total - first);
                dependency = decode.Schedule(dependency);
            }
            return dependency;
        }

        protected override void EndRead()
        {
            bool isRead = File.Close(out _) == ReadStatus.Complete;
            if (m_isPlanned)
                isRead &= ClosePlanned() == ReadStatus.Complete;
            if (isRead)
                return;
            var result = Result;
            result.Value = default;
            long offset = m_blocks.ChunkOf(m_blocks[Range.Block]).Offset;
            throw new PointCloudException(FailureCode.ReadFailed, m_blocks.Info.Path, offset,
                "the file could not be read, or has become shorter since it was opened");
        }

        protected override void Warn(DecodeResult result)
        {
            if (result.Error == LazError.None)
                return;
            var block = m_blocks[Range.Block];
            if (result.Error == LazError.Truncated || result.Error == LazError.NotAChunk)
                m_blocks.MarkEndOfChunk(block, block.FirstInChunk + Range.First + result.Points);
            m_blocks.WarnBroken(Range, result);
        }

        ReadStatus ClosePlanned()
        {
            m_isPlanned = false;
            m_plannedRead.JobHandle.Complete();
            var status = m_plannedRead.Status;
            m_plannedRead.Dispose();
            return status;
        }

        protected override void Cancel()
        {
            File.Cancel();
            if (m_isPlanned)
                m_plannedRead.Cancel();
        }

        protected override void DisposeMore()
        {
            m_copied.Complete();
            if (m_isPlanned)
                ClosePlanned();
        }
    }
}
