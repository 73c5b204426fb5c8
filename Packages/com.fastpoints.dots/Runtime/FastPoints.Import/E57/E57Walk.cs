using System;
using System.Collections.Generic;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.E57
{
    // Reads little more than the headers of packets: most writers make packets of nearly the same length, so that the places of
    // the next ones can be guessed and read together. If the guesses fail, everything is read.
    sealed class E57Walk : IDisposable
    {
        const int BufferPages = 2048;
        const int FirstPages = 256; // The first read covers all of a small file.

        // From one page before the expected one to two after it.
        const int GuessPages = 4;
        const int Guesses = BufferPages / GuessPages;

        // For shorter packets, reading everything between their headers is faster.
        const int MinGuessedBytes = 16 * E57Pages.DataBytes;

        // This many guesses must hold; otherwise the walk makes as many steps without guessing.
        const int MinHits = 32;
        const int StepsWithoutGuess = 8;

        readonly SourceInfo m_info;
        readonly E57Section m_section;
        readonly E57PagesRead m_read;
        NativeArray<E57StreamWalk> m_streams;
        NativeReference<E57WalkState> m_state;
        NativeList<E57Checkpoint> m_checkpoints;
        JobHandle m_walked;
        bool m_isFirst = true;
        bool m_isGuess;
        int m_stepsWithoutGuess;

        public E57Walk(E57File file, E57Section section, SourceInfo info)
        {
            m_info = info;
            m_section = section;
            var fields = section.Scan.Fields;
            m_read = new E57PagesRead(file, (int)Math.Min(BufferPages, file.Pages), Guesses, Allocator.Persistent);
            m_streams = new NativeArray<E57StreamWalk>(fields.Count, Allocator.Persistent);
            m_checkpoints = new NativeList<E57Checkpoint>(64, Allocator.Persistent);
            long records = section.RecordsPossible;
            int left = 0;
            for (int i = 0; i < fields.Count; i++)
            {
                if (fields[i].Bits <= 0)
                    continue;
                m_streams[i] = new E57StreamWalk
                {
                    Bits = fields[i].Bits,
                    BytesWanted = records / 8 * fields[i].Bits + (records % 8 * fields[i].Bits + 7) / 8,
                    CheckpointStep = section.CheckpointRecords / 8 * fields[i].Bits,
                };
                left++;
            }
            m_state = new NativeReference<E57WalkState>(new E57WalkState
            {
                Position = section.DataStart,
                StreamsLeft = records == 0 ? 0 : left,
            }, Allocator.Persistent);
        }

        // Coroutine; afterwards the section has its checkpoints and knows its number of records.
        public IEnumerator<JobStep> Run()
        {
            while (!m_state.Value.IsDone)
            {
                Plan(m_state.Value);
                while (!m_read.TryFetch())
                    yield return default;
                var read = m_read.Begin();
                m_walked = new WalkE57Job
                {
                    Input = m_read.Buffer,
                    IsDamaged = m_read.IsDamaged,
                    Extents = m_read.Extents,
                    ExtentCount = m_read.ExtentCount,
                    SectionEnd = m_section.End,
                    Streams = m_streams,
                    StreamCount = m_streams.Length,
                    State = m_state,
                    Checkpoints = m_checkpoints,
                }.Schedule(read);
                yield return m_walked;
                m_walked.Complete();
                m_read.End();
                AddCheckpoints();
            }
            Finish();
        }

        void Plan(E57WalkState state)
        {
            m_read.Clear();
            long page = state.Position / E57Pages.DataBytes;
            long lastPage = (m_section.End + E57Pages.DataBytes - 1) / E57Pages.DataBytes;
            if (m_isGuess && state.Packets < MinHits)
                m_stepsWithoutGuess = StepsWithoutGuess;
            m_isGuess = !m_isFirst && state.LastPacketBytes >= MinGuessedBytes && m_stepsWithoutGuess == 0;
            if (m_isGuess)
            {
                for (int i = 0; i < Guesses; i++)
                {
                    long guess = (state.Position + (long)i * state.LastPacketBytes) / E57Pages.DataBytes - (i > 0 ? 1 : 0);
                    if (guess >= lastPage || !m_read.Add(guess, GuessPages))
                        break;
                }
                return;
            }
            m_stepsWithoutGuess = Math.Max(0, m_stepsWithoutGuess - 1);
            m_read.Add(page, (int)Math.Min(m_isFirst ? FirstPages : BufferPages, lastPage - page));
            m_isFirst = false;
        }

        void AddCheckpoints()
        {
            for (int i = 0; i < m_checkpoints.Length; i++)
                m_section.CheckpointsOfStream[m_checkpoints[i].Stream].Add(m_checkpoints[i]);
            m_checkpoints.Clear();
        }

        void Finish()
        {
            var state = m_state.Value;
            var scan = m_section.Scan;
            long records = m_section.RecordsPossible;
            for (int i = 0; i < m_streams.Length; i++)
            {
                var stream = m_streams[i];
                if (stream.Bits == 0)
                    continue;
                m_section.EndOfStream[i] = stream.EndOffset != 0 ? stream.EndOffset : state.Position;
                if (stream.Bytes < stream.BytesWanted)
                    records = Math.Min(records, stream.Bytes * 8 / stream.Bits);
            }
            m_section.Records = records;
            if ((ulong)records < scan.RecordsClaimed)
                m_info.Warn(E57Pages.ToPhysical(state.Position), scan.Label + ": wanted " +
                    NumberText.Of(scan.RecordsClaimed) + " points, got " + NumberText.Of(records) + ": " +
                    E57Error.Text(state.Error == E57Error.None ? E57Error.SectionEnds : state.Error));
            if (state.DamagedHeaders > 0)
                m_info.Warn(state.FirstDamagedPage * E57Pages.PageBytes, scan.Label + ": the checksum of page " +
                    NumberText.Of(state.FirstDamagedPage) + " is wrong, which holds a packet's header (" + state.DamagedHeaders +
                    " such headers); they are read as they are");
        }

        public void Dispose()
        {
            m_walked.Complete();
            m_read.Dispose();
            m_streams.Dispose();
            m_state.Dispose();
            m_checkpoints.Dispose();
        }
    }

    // Steps from header to header as far as the pages at hand reach, and adds checkpoints where ranges of records begin.
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
        public NativeList<E57Checkpoint> Checkpoints;

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
                CountIfDamaged(ref state, extent, packet.Kind == E57Packet.DataKind ? packet.HeaderBytes : E57Packet.MinBytes);
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
            while (stream->NextCheckpoint < stream->Bytes + bytes && stream->NextCheckpoint < stream->BytesWanted)
            {
                Checkpoints.Add(new E57Checkpoint
                {
                    Stream = index,
                    PacketBytes = packetBytes,
                    PacketOffset = state.Position,
                    BytesBefore = stream->Bytes,
                });
                stream->NextCheckpoint += stream->CheckpointStep;
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

        void CountIfDamaged(ref E57WalkState state, in E57Extent extent, int headerBytes)
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
        public long BytesWanted; // 0 for a stream that need not be followed.

        // Between checkpoints, and where the next one is due.
        public long CheckpointStep;
        public long NextCheckpoint;
        public long EndOffset; // Logical, behind the packet with the last wanted byte; 0 until it is found.
    }

    struct E57WalkState
    {
        public long Position; // Logical, of the next packet.

        public int StreamsLeft;

        // In this step.
        public int Packets;
        public int LastPacketBytes;
        public int Error; // An E57Error, at Position.

        public int DamagedHeaders;
        public long FirstDamagedPage;

        public bool IsDone => StreamsLeft == 0 || Error != E57Error.None;
    }
}
