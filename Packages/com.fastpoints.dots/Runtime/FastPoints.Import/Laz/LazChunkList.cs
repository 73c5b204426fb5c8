using System;
using System.Collections.Generic;

namespace FastPoints.Laz
{
    // Any number of chunks. If each begins where the one before ends, as in a chunk table, it takes four bytes (eight if they do
    // not hold equal numbers of points) and a sum every 64. Other lists (hierarchies of octrees) take 24 bytes for a chunk.
    internal sealed class LazChunkList
    {
        const int GroupChunks = 64;

        readonly Pages m_bytes = new Pages();
        readonly List<long> m_offsetOfGroup = new List<long>();
        readonly List<long> m_pointOfGroup = new List<long>();
        Pages m_points; // Null while all but the last have as many points as the first.
        List<LazChunk> m_scattered; // Replaces all of the above if chunks are not contiguous.

        long m_firstPoints;
        long m_lastPoints;
        long m_end;

        public int Count => m_scattered?.Count ?? m_bytes.Count;
        public long PointCount { get; private set; }

        public long MaxPoints { get; private set; } // Of any chunk, now or before.

        public long MaxBytes { get; private set; }

        public bool AreContiguous => m_scattered == null; // Each begins where the one before ends, which FirstPointOf goes by.

        public LazChunk this[int chunk]
        {
            get
            {
                if (m_scattered != null)
                    return m_scattered[chunk];
                CheckChunk(chunk);
                long offset = m_offsetOfGroup[chunk / GroupChunks];
                for (int before = chunk - chunk % GroupChunks; before < chunk; before++)
                    offset += m_bytes[before];
                return new LazChunk { Offset = offset, Bytes = m_bytes[chunk], Points = PointsOf(chunk) };
            }
        }

        public long PointsOf(int chunk)
        {
            if (m_scattered != null)
                return m_scattered[chunk].Points;
            CheckChunk(chunk);
            return m_points != null ? m_points[chunk] : chunk == Count - 1 ? m_lastPoints : m_firstPoints;
        }

        public long FirstPointOf(int chunk)
        {
            CheckChunk(chunk);
            if (m_points == null)
                return chunk * m_firstPoints;
            long first = m_pointOfGroup[chunk / GroupChunks];
            for (int before = chunk - chunk % GroupChunks; before < chunk; before++)
                first += m_points[before];
            return first;
        }

        public void Add(in LazChunk chunk)
        {
            bool isContiguous = m_scattered == null && (Count == 0 || chunk.Offset == m_end) && chunk.Bytes <= uint.MaxValue
                && chunk.Points <= uint.MaxValue;
            if (isContiguous)
                AddContiguous(chunk);
            else
                Scatter().Add(chunk);
            PointCount += chunk.Points;
            MaxPoints = Math.Max(MaxPoints, chunk.Points);
            MaxBytes = Math.Max(MaxBytes, chunk.Bytes);
        }

        public void SetPoints(int chunk, long points)
        {
            var chunks = Scatter();
            var corrected = chunks[chunk];
            PointCount += points - corrected.Points;
            MaxPoints = Math.Max(MaxPoints, points);
            corrected.Points = points;
            chunks[chunk] = corrected;
        }

        public void Clear()
        {
            ClearContiguous();
            m_scattered = null;
            PointCount = MaxPoints = MaxBytes = 0;
        }

        void AddContiguous(in LazChunk chunk)
        {
            if (Count == 0)
                m_firstPoints = chunk.Points;
            else if (m_points == null && m_lastPoints != m_firstPoints)
                ListPointCounts();
            if (Count % GroupChunks == 0)
            {
                m_offsetOfGroup.Add(chunk.Offset);
                if (m_points != null)
                    m_pointOfGroup.Add(PointCount);
            }
            m_bytes.Add((uint)chunk.Bytes);
            m_points?.Add((uint)chunk.Points);
            m_lastPoints = chunk.Points;
            m_end = chunk.Offset + chunk.Bytes;
        }

        void ListPointCounts()
        {
            var points = new Pages();
            for (int chunk = 0; chunk < Count; chunk++)
            {
                if (chunk % GroupChunks == 0)
                    m_pointOfGroup.Add(chunk * m_firstPoints);
                points.Add((uint)PointsOf(chunk));
            }
            m_points = points;
        }

        List<LazChunk> Scatter()
        {
            if (m_scattered != null)
                return m_scattered;
            var chunks = new List<LazChunk>(Count);
            for (int chunk = 0; chunk < Count; chunk++)
                chunks.Add(this[chunk]);
            ClearContiguous();
            return m_scattered = chunks;
        }

        void ClearContiguous()
        {
            m_bytes.Clear();
            m_points = null;
            m_offsetOfGroup.Clear();
            m_pointOfGroup.Clear();
        }

        void CheckChunk(int chunk)
        {
            if (m_scattered != null)
                throw new InvalidOperationException("the chunks are not contiguous");
            if ((uint)chunk >= (uint)Count)
                throw new ArgumentOutOfRangeException(nameof(chunk), chunk, "the file has " + Count + " chunks");
        }

        // Growing copies none of them except those of the first page.
        sealed class Pages
        {
            const int PageBits = 16, PageLength = 1 << PageBits, MinLength = 16;

            readonly List<uint[]> m_pages = new List<uint[]>();

            public int Count { get; private set; }

            public uint this[int index] => m_pages[index >> PageBits][index & PageLength - 1];

            public void Add(uint number)
            {
                if (Count == m_pages.Count << PageBits)
                    m_pages.Add(new uint[Count == 0 ? MinLength : PageLength]);
                var page = m_pages[Count >> PageBits];
                int index = Count & PageLength - 1;
                if (index == page.Length)
                {
                    Array.Resize(ref page, 2 * index);
                    m_pages[0] = page;
                }
                page[index] = number;
                Count++;
            }

            public void Clear()
            {
                m_pages.Clear();
                Count = 0;
            }
        }
    }

    internal struct LazChunk
    {
        public long Offset;
        public long Bytes;
        public long Points; // As the file claims, or as a walk found.

        // A model of n symbols never makes one of them cheaper than about 1.44 * (n - 1) / 32768 bits, and a point takes at least
        // the symbols of its mask and coordinates: 0.007 bits.
        public const int MaxPointsPerByte = 2000;

        public static long MaxPoints(long bytes) => 1 + bytes * MaxPointsPerByte;
    }
}
