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
        // The chunk's header, at its start.
        [ReadOnly] public NativeArray<byte> Input;

        // Of each layer; 0 for one that is not wanted.
        [ReadOnly] public NativeArray<int> BytesPerPoint;

        // At most one for each wanted layer, or one of a single byte if there is nothing to read.
        public NativeArray<ReadCommand> Commands;

        // One value, whose count is set.
        public NativeArray<ReadCommandArray> CommandArray;

        // One value: the final input's.
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
}
