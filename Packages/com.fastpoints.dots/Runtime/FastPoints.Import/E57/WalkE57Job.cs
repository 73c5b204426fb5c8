using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.E57
{
    // Steps from header to header as far as the pages at hand reach, and marks where ranges of records begin.
    [BurstCompile]
    unsafe struct WalkE57Job : IJob
    {
        [ReadOnly] public NativeArray<byte> Input;
        [ReadOnly] public NativeArray<byte> IsDamaged;
        [ReadOnly] public NativeArray<E57Extent> Extents;
        public int ExtentCount;
        public long SectionEnd;
        public NativeArray<E57StreamWalk> Streams;
        public int StreamCount;
        public NativeReference<E57WalkState> State;
        public NativeList<E57Mark> Marks;

        public void Execute()
        {
            byte* input = (byte*)Input.GetUnsafeReadOnlyPtr();
            var streams = (E57StreamWalk*)Streams.GetUnsafePtr();
            var state = State.Value;
            state.Packets = 0;
            int at = 0;
            while (!state.IsDone)
            {
                while (at < ExtentCount && Extents[at].LogicalEnd <= state.Position)
                    at++;
                long toEnd = SectionEnd - state.Position;
                if (toEnd < E57Packet.MinBytes)
                {
                    state.Error = E57Error.SectionEnds;
                    break;
                }
                if (at == ExtentCount || Extents[at].LogicalStart > state.Position)
                    break;
                var extent = Extents[at];
                byte* p = input + extent.ToBuffer + state.Position;
                int error = E57Packet.Read(p, extent.LogicalEnd - state.Position, toEnd, StreamCount, out var packet,
                    out bool needsMore);
                if (needsMore)
                    break;
                if (error == E57Error.None && packet.IsRestart && IsWithinValue(streams))
                    error = E57Error.Restart;
                if (error != E57Error.None)
                {
                    state.Error = error;
                    break;
                }
                CheckHeader(ref state, extent, packet.Kind == E57Packet.DataKind ? packet.HeaderBytes : E57Packet.MinBytes);
                if (packet.Kind == E57Packet.DataKind)
                {
                    for (int i = 0; i < StreamCount; i++)
                        Follow(ref state, streams + i, i, E57Packet.StreamBytes(p, i), packet.Bytes);
                    state.Packets++;
                    state.LastPacketBytes = packet.Bytes;
                }
                state.Position += packet.Bytes;
            }
            State.Value = state;
        }

        void Follow(ref E57WalkState state, E57StreamWalk* stream, int index, int bytes, int packetBytes)
        {
            if (stream->Bytes >= stream->BytesWanted)
                return;
            while (stream->NextMark < stream->Bytes + bytes && stream->NextMark < stream->BytesWanted)
            {
                Marks.Add(new E57Mark
                {
                    Stream = index,
                    PacketBytes = packetBytes,
                    PacketOffset = state.Position,
                    BytesBefore = stream->Bytes,
                });
                stream->NextMark += stream->MarkStep;
            }
            stream->Bytes += bytes;
            if (stream->Bytes < stream->BytesWanted)
                return;
            stream->EndOffset = state.Position + packetBytes;
            state.StreamsLeft--;
        }

        // A restart changes nothing if every bytestream is at a value's end.
        bool IsWithinValue(E57StreamWalk* streams)
        {
            for (int i = 0; i < StreamCount; i++)
                if (streams[i].BytesWanted > 0 && streams[i].Bytes < streams[i].BytesWanted && streams[i].Bits > 0
                    && streams[i].Bytes * 8 % streams[i].Bits != 0)
                    return true;
            return false;
        }

        void CheckHeader(ref E57WalkState state, in E57Extent extent, int headerBytes)
        {
            long firstPage = state.Position / E57Pages.DataBytes;
            long lastPage = (state.Position + headerBytes - 1) / E57Pages.DataBytes;
            for (long page = firstPage; page <= lastPage; page++)
            {
                if (IsDamaged[(int)(page - extent.FirstPage + extent.BufferPage)] == 0)
                    continue;
                if (state.DamagedHeaders == 0)
                    state.FirstDamagedPage = page;
                state.DamagedHeaders++;
                return;
            }
        }
    }

    struct E57StreamWalk
    {
        public int Bits;
        public long Bytes;

        // 0 for a stream that need not be followed.
        public long BytesWanted;

        // From mark to mark, and where the next one is due.
        public long MarkStep;
        public long NextMark;

        // Logical, behind the packet with the last wanted byte; 0 until it has come.
        public long EndOffset;
    }

    struct E57WalkState
    {
        // Logical, of the next packet.
        public long Position;

        public int StreamsLeft;

        // In this step.
        public int Packets;
        public int LastPacketBytes;

        // An E57Error, at Position.
        public int Error;

        public int DamagedHeaders;
        public long FirstDamagedPage;

        public bool IsDone => StreamsLeft == 0 || Error != E57Error.None;
    }
}
