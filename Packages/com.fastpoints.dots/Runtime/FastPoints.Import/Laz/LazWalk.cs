using System;
using System.Collections.Generic;
using FastPoints.Las;
using FastPoints.Reading;

namespace FastPoints.Laz
{
    // Searches for the chunks of a file whose chunk table is lost, and takes checkpoints within pointwise chunks that are too
    // long for one block: in one pass over the file and in bounded memory. Layered chunks say how long they are. Pointwise ones
    // do not: they are decoded, and the next begins where one ends.
    sealed class LazWalk
    {
        const int PointsPerSlice = 16384;
        const int HeadersPerRead = 64;

        const long MaxCheckpointBytes = 64 << 20;

        const int MaxPrefixPoints = 1 << 18;

        readonly LazBlocks m_blocks;
        readonly LazFormat m_format;
        readonly RandomAccessFile m_source;
        readonly LazChunkList m_chunks;
        readonly List<LazCheckpoint> m_checkpoints;
        readonly List<BlockRange> m_checkpointsOfChunk = new List<BlockRange>();
        readonly long m_firstChunk;

        // Between checkpoints: a quarter of the limit for a whole chunk, since a block's points and its input lie in memory for
        // each slot.
        readonly int m_checkpointPoints;

        // Long known chunks are walked, and more are added if the table is lost.
        public LazWalk(LazBlocks blocks)
        {
            m_blocks = blocks;
            m_format = blocks.Format;
            m_source = blocks.Source;
            m_chunks = blocks.Chunks;
            m_checkpoints = blocks.Checkpoints;
            m_firstChunk = blocks.Las.Header.PointsOffset + LazChunkTable.TableOffsetSize;
            m_checkpointPoints = Math.Max(1, blocks.LongChunkPoints / 4);
        }

        // Of a long chunk, taken without a checkpoint. Without a table, the first chunks are searched up to as many points: about
        // 50 ms of decoding.
        public static int PrefixPoints(LazBlocks blocks) => Math.Min(blocks.LongChunkPoints, MaxPrefixPoints);

        public BlockRange CheckpointsOf(int chunk)
        {
            foreach (var range in m_checkpointsOfChunk)
                if (range.Block == chunk)
                    return range;
            return new BlockRange(chunk, 0, 0);
        }

        public IEnumerator<JobStep> Run(bool isTableLost) =>
            !isTableLost ? WalkLongChunks() : m_format.IsLayered ? WalkHeaders() : WalkStreams(false);

        // For a pointwise file without a table, adds the first chunks, with PrefixPoints points or a little more. A chunk that is
        // too long for a block is assumed to have the maximum length, and not walked.
        public IEnumerator<JobStep> WalkPrefix()
        {
            ulong claimed = m_blocks.Info.PointsClaimed;
            if (Math.Min(claimed, m_format.ChunkPoints) <= (ulong)m_blocks.LongChunkPoints)
                return WalkStreams(true);
            long at = m_firstChunk;
            if (at + m_format.RecordBytes <= m_source.Length)
                m_chunks.Add(new LazChunk
                {
                    Offset = at,
                    Bytes = m_source.Length - at,
                    Points = (long)Math.Min(claimed, m_format.ChunkPoints),
                });
            return NoWork();
        }

        static IEnumerator<JobStep> NoWork()
        {
            yield break;
        }

        IEnumerator<JobStep> WalkHeaders()
        {
            int headerBytes = LazLayer.ChunkHeaderBytes(m_format.RecordBytes, m_format.Layers.Length);
            long at = m_firstChunk;
            ulong pointsLeft = m_blocks.Info.PointsClaimed;
            for (int walked = 0; pointsLeft > 0 && at + headerBytes <= m_source.Length; walked++)
            {
                if (walked % HeadersPerRead == HeadersPerRead - 1)
                    yield return default;
                var header = m_source.Read(at, headerBytes, "chunk header");
                long points = header.UInt32(m_format.RecordBytes, "points of a chunk");
                long bytes = headerBytes;
                for (int i = 0; i < m_format.Layers.Length; i++)
                    bytes += header.UInt32(m_format.RecordBytes + 4 + 4 * i, "bytes of a layer");
                long there = Math.Min(bytes, m_source.Length - at);
                bool isChunk = points > 0 && points <= LazChunk.MaxPoints(there)
                    && (m_format.HasVariableChunks || points <= m_format.ChunkPoints);
                if (!isChunk || there > LazBlocks.MaxLayeredChunkBytes)
                {
                    m_blocks.Info.Warn(at, "there is no chunk here (" + NumberText.Of(points) + " points in "
                        + NumberText.Of(bytes) + " bytes): "
                        + NumberText.Of(m_chunks.Count) + " chunks were found before it");
                    break;
                }
                m_chunks.Add(new LazChunk { Offset = at, Bytes = there, Points = points });
                at += bytes;
                pointsLeft -= Math.Min(pointsLeft, (ulong)points);
            }
            Warn();
        }

        IEnumerator<JobStep> WalkStreams(bool isPrefix)
        {
            long at = m_firstChunk;
            ulong pointsLeft = m_blocks.Info.PointsClaimed;
            ulong pointsAfter = isPrefix ? pointsLeft - Math.Min(pointsLeft, (ulong)PrefixPoints(m_blocks)) : 0;
            using (var stream = new LazWalkStream(m_blocks.File, m_format))
            {
                while (pointsLeft > pointsAfter && at + m_format.RecordBytes <= m_source.Length)
                {
                    if (m_chunks.Count > 0 && IsNotAChunk(at, m_chunks.Count))
                        break;
                    long wanted = (long)Math.Min(pointsLeft, m_format.ChunkPoints);
                    int firstCheckpoint = m_checkpoints.Count;
                    stream.StartChunk(at, m_source.Length);
                    yield return JobStep.Of(WalkChunk(stream, wanted));
                    if (stream.PointsDone == 0)
                        break;
                    CloseChunk(m_chunks.Count, firstCheckpoint);
                    long end = stream.IsStopped ? m_source.Length : stream.FileOffset;
                    m_chunks.Add(new LazChunk { Offset = at, Bytes = end - at, Points = stream.PointsDone });
                    if (stream.IsStopped)
                        break;
                    at = stream.FileOffset;
                    pointsLeft -= (ulong)stream.PointsDone;
                }
            }
            if (!isPrefix)
                Warn();
        }

        // What follows is the chunk table, whose offset was lost, or nothing but zeros, as in a file that was allocated long
        // before it was written. A decoder would make points of both.
        bool IsNotAChunk(long at, int chunks)
        {
            var start = m_source.ReadUpTo(at, Math.Max(m_format.RecordBytes + 4, LazChunkTable.HeaderBytes));
            bool areZeros = true;
            foreach (byte value in start.Bytes)
                areZeros &= value == 0;
            long left = m_source.Length - at;
            return areZeros || left <= LazChunkTable.MaxBytes(chunks) && start.Bytes.Length >= LazChunkTable.HeaderBytes
                && start.UInt32(0, "chunk table version") == 0 && start.UInt32(4, "number of chunks") == chunks;
        }

        IEnumerator<JobStep> WalkLongChunks()
        {
            using var stream = new LazWalkStream(m_blocks.File, m_format);
            for (int c = 0; c < m_chunks.Count; c++)
            {
                var chunk = m_chunks[c];
                if (chunk.Points <= m_blocks.LongChunkPoints)
                    continue;
                int firstCheckpoint = m_checkpoints.Count;
                stream.StartChunk(chunk.Offset, chunk.Offset + chunk.Bytes);
                yield return JobStep.Of(WalkChunk(stream, chunk.Points));
                CloseChunk(c, firstCheckpoint);
                if (stream.PointsDone == chunk.Points)
                    continue;
                m_blocks.Info.Warn(stream.FileOffset, "chunk " + NumberText.Of(c) + ": wanted " + NumberText.Of(chunk.Points)
                    + " points, got " + NumberText.Of(stream.PointsDone) + ": the others are not in the file");
                m_chunks.SetPoints(c, stream.PointsDone);
            }
        }

        IEnumerator<JobStep> WalkChunk(LazWalkStream stream, long points)
        {
            bool isLong = points > m_blocks.LongChunkPoints;
            int firstCheckpoint = m_checkpoints.Count;
            while (stream.PointsDone < points && !stream.IsStopped)
            {
                while (stream.NeedsInput && !stream.TryFetch())
                    yield return default;
                if (stream.NeedsInput)
                    yield return stream.BeginRead();
                stream.EndRead();
                long untilCheckpoint = m_checkpointPoints - stream.PointsDone % m_checkpointPoints;
                yield return stream.Decode((int)Math.Min(Math.Min(PointsPerSlice, untilCheckpoint), points - stream.PointsDone));
                stream.EndDecode();
                bool isAtCheckpoint = isLong && stream.PointsDone > 0 && stream.PointsDone % m_checkpointPoints == 0 &&
                    stream.PointsDone < points;
                if (isAtCheckpoint && !stream.IsStopped
                    && (m_checkpoints.Count == 0 || m_checkpoints[m_checkpoints.Count - 1].FileOffset != stream.FileOffset))
                    m_checkpoints.Add(stream.Checkpoint());
            }
            // Points that were taken back at the end may have had a checkpoint.
            while (m_checkpoints.Count > firstCheckpoint && m_checkpoints[m_checkpoints.Count - 1].Point >= stream.PointsDone)
                m_checkpoints.RemoveAt(m_checkpoints.Count - 1);
        }

        void CloseChunk(int chunk, int firstCheckpoint)
        {
            int count = m_checkpoints.Count - firstCheckpoint;
            if (count > 0)
                m_checkpointsOfChunk.Add(new BlockRange(chunk, firstCheckpoint, count));
            DropStates();
        }

        // Drops the state of every second checkpoint while all of them exceed the memory limit.
        void DropStates()
        {
            long bytes = 0;
            foreach (var checkpoint in m_checkpoints)
                bytes += checkpoint.Bytes;
            bool drops = false;
            for (int i = 0; bytes > MaxCheckpointBytes && i < m_checkpoints.Count; i++)
            {
                if (!m_checkpoints[i].HasState)
                    continue;
                if (drops)
                {
                    bytes -= m_checkpoints[i].Bytes;
                    m_checkpoints[i].Drop();
                }
                drops = !drops;
            }
        }

        void Warn()
        {
            ulong points = (ulong)m_chunks.PointCount;
            if (points != m_blocks.Info.PointsClaimed)
                m_blocks.Info.Warn(LasHeader.At.LegacyCount, "the header claims "
                    + NumberText.Of(m_blocks.Info.PointsClaimed) + " points, the file holds " + NumberText.Of(points));
        }
    }
}
