using System;
using System.Collections;
using System.Collections.Generic;
using System.Globalization;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Text
{
    // Text of one point a line: XYZ, TXT, ASC, CSV, PTS. Separators and columns are guessed; names that a caller gives override
    // the guess. Coordinates are decimal numbers and stay exact: X, Y, Z are int64 in steps of a power of ten, chosen by the
    // digits in a sample of the file. A block's count includes comments and bad lines, which decoding leaves out and counts.
    internal sealed class XyzReader : LineReader
    {
        public const int MaxBlockBytes = 256 << 10;

        // The last line may extend this many bytes behind its block: longer ones are not points.
        public const int MaxLineBytes = 16 << 10;
        const int DefaultDecimals = 4; // Printed digits that are kept even if the sample has zeros there.

        readonly XyzSniff m_sniff;
        readonly string[] m_names;
        readonly int[] m_decimals = new int[3];
        readonly RunningWarning[] m_warnings = Array.ConvertAll(new int[5], _ => new RunningWarning());
        readonly BitArray m_isReported = new BitArray(0);
        string m_firstError;

        XyzReader(XyzSniff sniff, string[] names, SourceInfo info)
            : base(info, new SourceHandle(info.Path), sniff.DataOffset)
        {
            m_sniff = sniff;
            m_names = names;
        }

        internal XyzDialect Dialect => m_sniff.Dialect;

        public static XyzReader Open(RandomAccessFile source, string[] textColumns)
        {
            var sniff = XyzSniff.Find(source, textColumns);
            if (sniff == null)
                return null;
            int columns = sniff.Columns.Length;
            string[] given = textColumns ?? sniff.Names;
            string origin = textColumns != null ? "as told" : sniff.Names != null ? "by the file's header" :
                "guessed from " + sniff.Rows.ToString("N0", CultureInfo.InvariantCulture) + " lines";
            if (given != null && given.Length > columns)
                throw PointCloudException.Wanted(FailureCode.BadInput, source.Path, sniff.DataOffset, "columns in a line",
                    given.Length + " (" + string.Join(", ", given) + ")", columns);
            string[] names = given != null ? XyzNames.Of(given, columns) : XyzNames.Guess(sniff.Columns, sniff.UnitVectorShares);
            if (!XyzNames.HavePosition(names))
                throw PointCloudException.Wanted(FailureCode.Unsupported, source.Path, 0, "columns of the text",
                    "x, y and z among them (name them to override)", string.Join(", ", given ?? names));
            var reader = new XyzReader(sniff, names, new SourceInfo { Path = source.Path, FileBytes = source.Length });
            reader.Describe(origin);
            if (given != null && XyzNames.AreDegrees(given))
                (reader.Info.Crs.MetresPerUnit, reader.Info.Crs.Kind) = (double.NaN, CrsKind.Geographic);
            return reader;
        }

        void Describe(string origin)
        {
            var info = Info;
            info.Format = m_sniff.CountClaimed >= 0 ? "PTS" : "XYZ";
            info.PointsClaimed = (ulong)Math.Max(0, m_sniff.CountClaimed);
            info.HasPointsClaimed = m_sniff.CountClaimed >= 0;
            var attributes = new List<PointAttribute>();
            var shown = new List<string>();
            for (int i = 0; i < m_names.Length; i++)
            {
                shown.Add(m_names[i] ?? "-");
                if (m_names[i] == null)
                    continue;
                int axis = AttributeNames.AxisOf(m_names[i]);
                if (axis >= 0)
                    m_decimals[axis] = DecimalsOf(m_sniff.Columns[i]);
                attributes.Add(new PointAttribute(m_names[i],
                    axis >= 0 ? AttributeType.Int64 : m_sniff.Columns[i].TypeOf(m_names[i])));
            }
            info.Schema = new PointSchema(attributes);
            info.Transform.Scale = new double3(StepOf(0), StepOf(1), StepOf(2));
            info.AddFact("columns", string.Join(" ", shown) + " (" + origin + ")");
            info.AddFact("separator", m_sniff.Dialect.Name);
            info.AddFact("decimals", string.Join(", ", m_decimals));
            if (m_sniff.HeaderLines > 0)
                info.AddFact("header lines", NumberText.Of(m_sniff.HeaderLines));
        }

        // The digits that the sample has, limited to those that a coordinate on the grid can hold.
        static int DecimalsOf(XyzColumn column)
        {
            int decimals = Math.Max(column.Decimals, Math.Min(column.DecimalsPrinted, DefaultDecimals));
            // One digit is left for coordinates that are larger than the sample's.
            double room = CommonGrid.Limit / (10 * Math.Max(1, column.MaxMagnitude));
            return Math.Max(0, Math.Min(decimals, Math.Min(18, (int)Math.Floor(Math.Log10(room)))));
        }

        double StepOf(int axis)
        {
            // Powers of ten are exact doubles to 10^22, so that this is the double nearest to 0.001.
            double power = 1;
            for (int i = 0; i < m_decimals[axis]; i++)
                power *= 10;
            return 1 / power;
        }

        private protected override void OnBlocksFound() => m_isReported.Length = Blocks.Count;

        public override IEnumerator<JobStep> IndexBlocks()
        {
            if (BlocksAreKnown)
                yield break;
            using var scan = new AsciiRowScan(this, File, m_sniff.DataOffset, MaxBlockBytes, 0, ulong.MaxValue);
            while (scan.Next(out var handle))
                yield return handle;
            Blocks.Set(scan.TakeBlocks());
            m_isReported.Length = Blocks.Count;
            m_isReported.SetAll(false);
            foreach (var warning in m_warnings)
                warning.Reset();
            AreAllFound = true;
            Info.PointsReadable = scan.Points;
            if (m_sniff.CountClaimed >= 0 && m_sniff.CountClaimed != scan.Points)
                Info.Warn(0, "points: wanted " + NumberText.Of(m_sniff.CountClaimed) + ", got " +
                    NumberText.Of(scan.Points) + " lines");
        }

        private protected override int BytesBehindBlock => MaxLineBytes;

        public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator) =>
            new XyzRead(this, wanted, capacity, allocator);

        internal SegmentBlock Block(int block) => Blocks[block];

        internal XyzStep[] StepsFor(PointBatch batch)
        {
            var steps = new XyzStep[m_names.Length];
            for (int i = 0; i < steps.Length; i++)
            {
                int axis = m_names[i] == null ? -1 : AttributeNames.AxisOf(m_names[i]);
                int column = m_names[i] == null ? -1 : batch.Schema.IndexOf(m_names[i]);
                var step = new XyzStep
                {
                    Kind = m_names[i] == null ? XyzStepKind.Skip : XyzStepKind.Check,
                    IsPosition = axis >= 0,
                };
                if (column >= 0 || axis >= 0)
                {
                    step.Type = column >= 0 ? batch.Schema[column].Type : AttributeType.Int64;
                    step.Bytes = step.Type.SizeOf();
                    step.IsStored = column >= 0;
                    step.ColumnOffsetBytes = column >= 0 ? batch.Column(column).OffsetBytes : 0;
                    step.Decimals = axis >= 0 ? m_decimals[axis] : 0;
                    step.Kind = axis >= 0 ? XyzStepKind.Coordinate
                        : step.Type == AttributeType.Float32 ? XyzStepKind.Float32
                        : step.Type == AttributeType.Float64 ? XyzStepKind.Float64 : XyzStepKind.Integer;
                }
                steps[i] = step;
            }
            return steps;
        }

        // Once for each block: warnings have running counts.
        internal void Warn(BlockRange range, in XyzAnomalies found)
        {
            if (m_isReported[range.Block])
                return;
            m_isReported[range.Block] = true;
            if (found.BadRows > 0)
            {
                m_firstError ??= TextOf(found.FirstError);
                Warn(0, found.BadRows, found.FirstBadRow, " lines are no points and left out; the first one: " + m_firstError);
            }
            Warn(1, found.Rounded, found.FirstRounded, " coordinates have more digits than the lines that were looked at " +
                "first: rounded to " + NumberText.Of(Info.Transform.Scale));
            Warn(2, found.Inexact, found.FirstInexact, " values do not fit the whole numbers that their column has elsewhere: " +
                "the nearest that do were taken");
            Warn(3, found.EmptyValues, found.FirstEmpty, " values are empty: 0 was taken");
            Warn(4, found.RowsWithMore, found.FirstWithMore, " lines have more values than there are columns: left out");
        }

        void Warn(int kind, int count, long firstOffset, string text)
        {
            if (count > 0)
                m_warnings[kind].Add(Info, count, firstOffset, sum => sum + text);
        }

        static string TextOf(XyzError error) => error switch
        {
            XyzError.TooFewValues => "too few values",
            XyzError.NoNumber => "not a finite number",
            XyzError.TooLarge => "a coordinate beyond what a grid of these steps holds",
            _ => "longer than 16,384 bytes",
        };
    }

    sealed class XyzRead : OwningBlockRead
    {
        readonly XyzReader m_reader;
        readonly NativeArray<XyzStep> m_steps;
        readonly NativeReference<XyzAnomalies> m_anomalies;

        public XyzRead(XyzReader reader, PointSchema wanted, int capacity, Allocator allocator)
            : base(reader, wanted, capacity, allocator)
        {
            m_reader = reader;
            OwnFile(Math.Min(XyzReader.MaxBlockBytes + XyzReader.MaxLineBytes, reader.Info.FileBytes), allocator);
            m_steps = Own(new NativeArray<XyzStep>(reader.StepsFor(Points), allocator));
            m_anomalies = Own(new NativeReference<XyzAnomalies>(allocator));
        }

        protected override JobHandle Schedule(BlockRange range)
        {
            var lines = AsciiRange.Of(m_reader.Block(range.Block), range, m_reader.Info.FileBytes, XyzReader.MaxLineBytes);
            return new DecodeXyzJob
            {
                Input = FileRead.Buffer,
                Range = lines,
                Dialect = m_reader.Dialect,
                Steps = m_steps,
                Output = Points.Bytes,
                Result = Result,
                Anomalies = m_anomalies,
            }.Schedule(DependencyOf(FileRead.Begin(m_reader.File, lines.Offset, lines.Bytes)));
        }

        protected override void Warn(DecodeResult result) => m_reader.Warn(Range, m_anomalies.Value);
    }
}
