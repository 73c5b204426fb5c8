using System;
using System.Collections;
using System.Collections.Generic;
using System.Globalization;
using System.Text;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Text
{
    // The ten lines before the points of each scan: columns, rows, the scanner's position and axes, and the matrix from
    // its coordinates to the world, row by row, the translation last.
    struct PtxScanHeader
    {
        public const int MaxBytes = 4096;

        static readonly int[] s_valuesOfLine = { 1, 1, 3, 3, 3, 3, 4, 4, 4, 4 };

        public ulong Columns;
        public ulong Rows;
        public double3 Position; // Where points are in the world's coordinates already.
        public double3 X, Y, Z, Shift; // World = x * X + y * Y + z * Z + Shift.

        public int Bytes;

        public double3 Scanner => math.all(Shift == 0) ? Position : Shift;

        public override string ToString() => "x " + NumberText.Of(X) + ", y " + NumberText.Of(Y) + ", z " + NumberText.Of(Z) +
            ", shift " + NumberText.Of(Shift);

        // Lines of points, those without a return included.
        public ulong GridPoints => Rows != 0 && Columns > ulong.MaxValue / Rows ? ulong.MaxValue : Columns * Rows;

        public static bool TryParse(ReadOnlySpan<byte> bytes, out PtxScanHeader header)
        {
            header = default;
            var rows = new double4[4];
            for (int line = 0; line < s_valuesOfLine.Length;)
            {
                int end = bytes.Slice(header.Bytes).IndexOfAny((byte)'\n', (byte)'\r');
                if (end < 0)
                    return false;
                string[] words = Encoding.ASCII.GetString(bytes.Slice(header.Bytes, end).ToArray())
                    .Split((char[])null, StringSplitOptions.RemoveEmptyEntries);
                header.Bytes += end + 1;
                if (words.Length == 0)
                    continue;
                if (words.Length != s_valuesOfLine[line] || !TryParseLine(ref header, rows, line, words))
                    return false;
                line++;
            }
            (header.X, header.Y, header.Z, header.Shift) = (rows[0].xyz, rows[1].xyz, rows[2].xyz, rows[3].xyz);
            return true;
        }

        static bool TryParseLine(ref PtxScanHeader header, double4[] rows, int line, string[] words)
        {
            if (line < 2)
                return ulong.TryParse(words[0], NumberStyles.None, CultureInfo.InvariantCulture,
                    out line == 0 ? ref header.Columns : ref header.Rows);
            for (int i = 0; i < words.Length; i++)
            {
                if (!NumberText.TryRead(words[i], out double value) || double.IsNaN(value) || double.IsInfinity(value))
                    return false;
                if (line == 2)
                    header.Position[i] = value;
                if (line >= 6)
                    rows[line - 6][i] = value;
            }
            return true;
        }
    }

    // PTX (Leica): scans in text, one after the other, each with a header of ten lines and a grid point a line, row by
    // row. All scans are one cloud in the world's coordinates; PointSourceId is the scan's number, from 1. Grid points
    // without a return count among a block's points, and are left out when it is decoded.
    internal sealed class PtxReader : SegmentReader
    {
        const int MaxBlockBytes = 256 << 10;
        const int MaxLineBytes = 16 << 10;
        const int MaxScans = ushort.MaxValue, MaxScansShown = 100;

        readonly List<PtxScanHeader> m_scans = new List<PtxScanHeader>();
        readonly List<ushort> m_scanOfBlock = new List<ushort>();
        readonly int m_valuesPerLine;
        readonly RunningWarning m_badRows = new RunningWarning();
        BitArray m_isReported;
        bool m_areAllFound;

        PtxReader(RandomAccessFile source, PtxScanHeader first, int values)
            : base(new SourceInfo { Path = source.Path, FileBytes = source.Length }, new SourceHandle(source.Path))
        {
            m_valuesPerLine = values;
            m_scans.Add(first);
            var attributes = new List<PointAttribute>();
            foreach (string axis in new[] { AttributeNames.X, AttributeNames.Y, AttributeNames.Z })
                attributes.Add(new PointAttribute(axis, AttributeType.Float64));
            if (values >= 4)
                attributes.Add(new PointAttribute(AttributeNames.Intensity, AttributeType.Float32));
            for (int i = 0; i < values - 4; i++)
                attributes.Add(new PointAttribute(PlyPlan.ColorNames[i], AttributeType.UInt8));
            attributes.Add(new PointAttribute(AttributeNames.PointSourceId, AttributeType.UInt16));
            Info.Format = "PTX";
            Info.HasPointsClaimed = false;
            Info.Schema = new PointSchema(attributes);
            Info.UnexportableFacts = "the scans' matrices";
            Info.Losses.Add(new Loss("the scans' grids", Info.Path, "points are kept without their neighbours in them"));
            Info.AddFact("first scan", NumberText.Of(first.Columns) + " columns of " + NumberText.Of(first.Rows) + " places");
        }

        public override bool BlocksAreKnown => m_areAllFound;

        // Null if the file does not begin with the header of a scan; Unsupported if its lines have not 3, 4 or 7 values.
        public static PtxReader Open(RandomAccessFile source)
        {
            byte[] head = source.ReadUpTo(0, 2 * PtxScanHeader.MaxBytes).Bytes;
            if (!PtxScanHeader.TryParse(head, out var first))
                return null;
            int at = first.Bytes;
            while (at < head.Length && head[at] <= ' ')
                at++;
            int end = at;
            while (end < head.Length && !AsciiLines.IsLineEnd(head[end]))
                end++;
            int values = System.Text.Encoding.ASCII.GetString(head, at, end - at)
                .Split((char[])null, StringSplitOptions.RemoveEmptyEntries).Length;
            if (values != 0 && values != 3 && values != 4 && values != 7)
                throw PointCloudException.Wanted(FailureCode.Unsupported, source.Path, at, "values in a line",
                    "3 (x y z), 4 (intensity) or 7 (r g b)", values);
            return new PtxReader(source, first, values);
        }

        public override IEnumerator<JobStep> IndexBlocks()
        {
            if (m_areAllFound)
                yield break;
            m_scans.Clear();
            m_scanOfBlock.Clear();
            var blocks = new List<SegmentBlock>();
            long points = 0, offset = 0;
            using var read = new NativeFileRead(Math.Min(MaxBlockBytes + MaxLineBytes, Info.FileBytes), Allocator.Persistent);
            while (offset < Info.FileBytes)
            {
                int bytes = (int)Math.Min(PtxScanHeader.MaxBytes, Info.FileBytes - offset);
                while (!read.TryFetch(File.Path, offset, bytes))
                    yield return default;
                yield return read.Begin(File, offset, bytes);
                read.End();
                if (!ReadHeader(read, bytes, offset))
                    break;
                var header = m_scans[m_scans.Count - 1];
                offset += header.Bytes;
                using var scan = new AsciiRowScan(this, File, offset, MaxBlockBytes, 0, header.GridPoints);
                while (scan.Next(out var handle))
                    yield return handle;
                var found = scan.TakeBlocks();
                for (int i = 0; i < found.Length; i++)
                {
                    found[i].FirstPoint += points;
                    m_scanOfBlock.Add((ushort)m_scans.Count);
                }
                blocks.AddRange(found);
                points += scan.Points;
                if ((ulong)scan.Points < header.GridPoints)
                {
                    Info.Warn(Info.FileBytes, "scan " + NumberText.Of(m_scans.Count) + ": wanted " +
                        NumberText.Of(header.GridPoints) + " places, got " + NumberText.Of(scan.Points) +
                            ": the file ends before");
                    break;
                }
                if (found.Length == 0)
                    continue;
                var last = found[found.Length - 1];
                bytes = (int)Math.Min(last.Bytes + MaxLineBytes, Info.FileBytes - last.OffsetBytes);
                while (!read.TryFetch(File.Path, last.OffsetBytes, bytes))
                    yield return default;
                yield return read.Begin(File, last.OffsetBytes, bytes);
                read.End();
                offset = last.OffsetBytes + EndOfRows(read.Buffer, bytes, last);
            }
            Info.PointsReadable = Blocks.Set(blocks.ToArray());
            if (points == 0)
                throw new PointCloudException(FailureCode.Truncated, Info.Path, offset, "the scans have no points");
            Info.AddFact("scans", NumberText.Of(m_scans.Count));
            for (int i = 0; i < m_scans.Count && i < MaxScansShown; i++)
                Info.AddFact("scan " + NumberText.Of(i + 1), m_scans[i].ToString());
            m_isReported = new BitArray(blocks.Count);
            Info.Scanners = m_scans.ConvertAll(scan => scan.Scanner).ToArray();
            m_areAllFound = true;
        }

        // False if there is no other scan: blank lines may end the file.
        bool ReadHeader(NativeFileRead read, int bytes, long offset)
        {
            byte[] text = read.Buffer.GetSubArray(0, bytes).ToArray();
            bool isBlank = true;
            foreach (byte b in text)
                isBlank &= b <= ' ';
            if (isBlank)
                return false;
            bool isHeader = PtxScanHeader.TryParse(text, out var header) && m_scans.Count < MaxScans;
            if (isHeader)
                m_scans.Add(header);
            else
                Info.Warn(offset, "behind scan " + NumberText.Of(m_scans.Count) + ": wanted the header of another, got other " +
                    "text, which is left out");
            return isHeader;
        }

        static unsafe int EndOfRows(NativeArray<byte> text, int bytes, in SegmentBlock block)
        {
            byte* start = (byte*)text.GetUnsafeReadOnlyPtr(), p = start, end = start + bytes;
            for (int row = block.StartsInRow ? -1 : 0; row < block.Points; row++)
            {
                while (row >= 0 && p < end && *p <= ' ')
                    p++;
                while (p < end && !AsciiLines.IsLineEnd(*p))
                    p++;
            }
            return (int)(p - start);
        }

        private protected override int BytesBehindBlock => MaxLineBytes;

        public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator) =>
            new PtxRead(this, wanted, capacity, allocator);

        internal DecodePtxJob JobFor(BlockRange range, PointBatch batch)
        {
            int Offset(string name)
            {
                int column = batch.Schema.IndexOf(name);
                return column < 0 ? -1 : batch.Column(column).OffsetBytes;
            }
            ushort scan = m_scanOfBlock[range.Block];
            return new DecodePtxJob
            {
                Range = AsciiRange.Of(Blocks[range.Block], range, Info.FileBytes, MaxLineBytes),
                Scan = m_scans[scan - 1],
                ScanNumber = scan,
                Columns = new PtxColumnOffsets
                {
                    ValuesPerLine = m_valuesPerLine,
                    Position = new int3(Offset(AttributeNames.X), Offset(AttributeNames.Y), Offset(AttributeNames.Z)),
                    Color = new int3(Offset(AttributeNames.Red), Offset(AttributeNames.Green), Offset(AttributeNames.Blue)),
                    Intensity = Offset(AttributeNames.Intensity),
                    ScanNumber = Offset(AttributeNames.PointSourceId),
                },
            };
        }

        internal long SlotBytes => Math.Min(MaxBlockBytes + MaxLineBytes, Info.FileBytes);

        internal void Warn(BlockRange range, in PtxAnomalies found)
        {
            if (m_isReported[range.Block])
                return;
            m_isReported[range.Block] = true;
            if (found.BadRows > 0)
                m_badRows.Add(Info, found.BadRows, found.FirstBadRow,
                    sum => sum + " lines are no points of " + NumberText.Of(m_valuesPerLine) + " values and left out");
        }
    }

    sealed class PtxRead : OwningBlockRead
    {
        readonly PtxReader m_reader;
        readonly NativeReference<PtxAnomalies> m_anomalies;

        public PtxRead(PtxReader reader, PointSchema wanted, int capacity, Allocator allocator)
            : base(reader, wanted, capacity, allocator)
        {
            m_reader = reader;
            OwnFile(reader.SlotBytes, allocator);
            m_anomalies = Own(new NativeReference<PtxAnomalies>(allocator));
        }

        protected override JobHandle Schedule(BlockRange range)
        {
            var job = m_reader.JobFor(range, Points);
            job.Input = FileRead.Buffer;
            job.Output = Points.Bytes;
            job.Result = Result;
            job.Anomalies = m_anomalies;
            return job.Schedule(DependencyOf(FileRead.Begin(m_reader.File, job.Range.Offset, job.Range.Bytes)));
        }

        protected override void Warn(DecodeResult result) => m_reader.Warn(Range, m_anomalies.Value);
    }
}
