using System;
using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Reading;

namespace FastPoints.E57
{
    sealed class E57Blocks
    {
        // It bounds a slot's memory, whatever a file claims.
        const int MaxBlockPages = 24 << 10;

        // Records that take no bytes at all prove nothing about their number.
        const ulong MaxRecordsWithoutBits = 65536;

        readonly List<E57Section> m_sections;
        readonly HashSet<int> m_reportedBlocks = new HashSet<int>();
        readonly Dictionary<string, (string Text, RunningWarning Warning)> m_warnings =
            new Dictionary<string, (string, RunningWarning)>();
        int m_blockCount;
        int m_maxPoints;
        int m_maxPages = 1;

        public E57Blocks(E57File file, SourceInfo info, E57Schema schema, List<E57Section> sections)
        {
            File = file;
            Info = info;
            Schema = schema;
            m_sections = sections;
            foreach (var section in sections)
                HasVectors |= schema.HasVectorPositions || E57Schema.HasVectorNormals(section.Scan);
            AreKnown = info.PointsClaimed == 0;
        }

        public E57File File { get; }
        public SourceInfo Info { get; }
        public E57Schema Schema { get; }

        // Some scan's positions or normals pass through rows of doubles.
        public bool HasVectors { get; }

        public bool AreKnown { get; private set; }
        public int Count => Known(m_blockCount);
        public int MaxPoints => Known(m_maxPoints);
        public int MaxPages => Known(m_maxPages);

        public IEnumerator<JobStep> Find()
        {
            if (AreKnown)
                yield break;
            long points = 0;
            foreach (var section in m_sections)
            {
                if (section.Scan.RecordsClaimed > 0 && section.Scan.RecordBits == 0)
                {
                    AddWithoutBits(section);
                }
                else if (section.Scan.RecordsClaimed > 0)
                {
                    using (var walk = new E57Walk(File, section, Info))
                        yield return JobStep.Of(walk.Run());
                    LimitPages(section);
                }
                section.FirstBlock = m_blockCount;
                section.FirstPoint = points;
                m_blockCount += section.BlockCount;
                points += section.Records;
                m_maxPoints = (int)Math.Max(m_maxPoints, Math.Min(section.BlockPoints, section.Records));
            }
            if (points == 0)
            {
                // The last walk's warning says what is wrong, and where.
                var reason = Info.Warnings.Count > 0 ? Info.Warnings[Info.Warnings.Count - 1] : new CloudWarning(null, -1, "");
                throw PointCloudException.Wanted(FailureCode.Truncated, Info.Path, reason.ByteOffset, "points",
                    NumberText.Of(Info.PointsClaimed), "0: " + reason.Text);
            }
            Info.PointsReadable = points;
            AreKnown = true;
        }

        public E57Section SectionOf(int block)
        {
            if ((uint)block >= (uint)Known(m_blockCount))
                throw new ArgumentOutOfRangeException(nameof(block), block, "the source has " + m_blockCount + " blocks");
            int low = 0, high = m_sections.Count;
            while (high - low > 1)
            {
                int middle = (low + high) / 2;
                if (m_sections[middle].FirstBlock <= block)
                    low = middle;
                else
                    high = middle;
            }
            return m_sections[low];
        }

        public int PointsOf(int block)
        {
            var section = SectionOf(block);
            return (int)Math.Min(section.BlockPoints, section.Records - (long)(block - section.FirstBlock) * section.BlockPoints);
        }

        public void Warn(BlockRange range, DecodeResult result, in E57Anomalies anomalies)
        {
            bool isNew = range.First == 0 && range.Count == PointsOf(range.Block) && m_reportedBlocks.Add(range.Block);
            if (result.Error != E57Error.None)
                Warn("points are left out: " + E57Error.Text(result.Error), result.ErrorOffset,
                    isNew ? range.Count - result.Points : 0);
            if (anomalies.Invalid > 0)
            {
                Info.PointsMarkedInvalid += isNew ? anomalies.Invalid : 0;
                Warn("points that their scan marks as invalid are left out", -1, isNew ? anomalies.Invalid : 0);
            }
            if (anomalies.Damaged > 0)
                Warn("the checksum of page " + anomalies.FirstDamagedPage + " is wrong (" + anomalies.DamagedPages +
                    " pages of this block are damaged): points that lie in them are left out",
                    anomalies.FirstDamagedPage * E57Pages.PageBytes, isNew ? anomalies.Damaged : 0);
            if (anomalies.Misfits > 0)
                Warn("integers above the maximum of their field: the maximum was taken", -1, isNew ? anomalies.Misfits : 0);
        }

        void AddWithoutBits(E57Section section)
        {
            section.Records = (long)Math.Min(section.Scan.RecordsClaimed, MaxRecordsWithoutBits);
            if (section.Scan.RecordsClaimed > MaxRecordsWithoutBits)
                Info.Warn(-1, section.Scan.Label + ": its records take no bytes, all being equal: " + MaxRecordsWithoutBits +
                    " of the " + NumberText.Of(section.Scan.RecordsClaimed) + " claimed are given");
        }

        // Ends a scan before the first block whose fields lie too far apart.
        void LimitPages(E57Section section)
        {
            var firstPages = new long[section.EndOfStream.Length];
            var endPages = new long[section.EndOfStream.Length];
            for (long first = 0; first < section.Records; first += section.BlockPoints)
            {
                int runs = section.PagesOf(first, Math.Min(first + section.BlockPoints, section.Records), null, firstPages,
                    endPages);
                long pages = 0;
                for (int i = 0; i < runs; i++)
                    pages += endPages[i] - firstPages[i];
                if (pages > MaxBlockPages)
                {
                    Info.Warn(firstPages[0] * E57Pages.PageBytes, section.Scan.Label + ": wanted " +
                        NumberText.Of(section.Records) +
                        " points, got " + NumberText.Of(first) + ": " + E57Error.Text(E57Error.TooWide));
                    section.Records = first;
                    return;
                }
                m_maxPages = (int)Math.Max(m_maxPages, pages);
            }
        }

        void Warn(string text, long offset, long count)
        {
            string key = text.Length > 24 ? text.Substring(0, 24) : text;
            if (!m_warnings.TryGetValue(key, out var known))
                m_warnings.Add(key, known = (text, new RunningWarning()));
            known.Warning.Add(Info, count, offset, sum => sum == "0" ? known.Text : known.Text + " (" + sum + " so far)");
        }

        T Known<T>(T value) => AreKnown ? value : throw new InvalidOperationException("FindBlocks comes first");
    }
}
