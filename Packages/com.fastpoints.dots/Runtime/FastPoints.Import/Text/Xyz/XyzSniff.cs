using System;
using System.Collections.Generic;
using System.Text;
using FastPoints.Reading;

namespace FastPoints.Text
{
    // Finds out whether a file is lines of numbers, and which: separators, header lines, columns and their ranges, from its
    // beginning and some segments farther on.
    sealed unsafe class XyzSniff
    {
        const int HeadBytes = 64 << 10;
        const int SegmentBytes = 4 << 10;
        const int Segments = 64;
        const int MaxColumns = 256;
        const double MinRowFraction = 0.8; // Share of the first lines that must be rows of the same number of values.

        readonly RandomAccessFile m_source;
        readonly string[] m_given;
        XyzDialect m_dialect;
        int[] m_unitVectors;
        DecimalDigits[] m_numbers;
        double[] m_values;
        byte[] m_line = new byte[256];

        XyzSniff(RandomAccessFile source, string[] given)
        {
            m_source = source;
            m_given = given;
        }

        public XyzDialect Dialect => m_dialect;
        public long DataOffset { get; private set; }
        public int HeaderLines { get; private set; }

        public long CountClaimed { get; private set; } = -1; // The number that stands alone before the rows (PTS), or -1.

        public string[] Names { get; private set; }
        public XyzColumn[] Columns { get; private set; }

        // For each column, the share of rows that have a vector of length 1 from there on.
        public double[] UnitVectorShares { get; private set; }

        public int Rows { get; private set; }

        // Null if the file is something else. Columns that the caller names "-" may hold anything.
        public static XyzSniff Find(RandomAccessFile source, string[] given)
        {
            byte[] head = source.ReadUpTo(0, HeadBytes).Bytes;
            if (!IsText(head))
                return null;
            var sniff = new XyzSniff(source, given);
            int start = head.Length >= 3 && head[0] == 0xEF && head[1] == 0xBB && head[2] == 0xBF ? 3 : 0;
            int end = head.Length == source.Length ? head.Length : LastLineEnd(head);
            var lines = LinesOf(head, start, end);
            if (lines.Count == 0 || !sniff.ChooseDialect(head, lines) || !sniff.ReadHead(head, lines))
                return null;
            sniff.ReadSegments();
            for (int i = 0; i < sniff.UnitVectorShares.Length; i++)
                sniff.UnitVectorShares[i] = sniff.m_unitVectors[i] / (double)Math.Max(1, sniff.Rows);
            return sniff;
        }

        static bool IsText(byte[] head)
        {
            foreach (byte b in head)
                if (b < 9 || b > 13 && b < 32)
                    return false;
            return head.Length > 0;
        }

        static bool IsLineEnd(byte b) => b == '\n' || b == '\r';

        static int LastLineEnd(byte[] bytes)
        {
            int end = bytes.Length;
            while (end > 0 && !IsLineEnd(bytes[end - 1]))
                end--;
            return end;
        }

        static List<(int First, int End)> LinesOf(byte[] bytes, int first, int end)
        {
            var lines = new List<(int, int)>();
            while (first < end)
            {
                while (first < end && bytes[first] <= ' ')
                    first++;
                int last = first;
                while (last < end && !IsLineEnd(bytes[last]))
                    last++;
                if (last > first)
                    lines.Add((first, last));
                first = last;
            }
            return lines;
        }

        bool ChooseDialect(byte[] bytes, List<(int First, int End)> lines)
        {
            bool mayStartWithText = m_given != null && m_given.Length > 0 && m_given[0] == "-";
            bool hasComma = false, hasSemicolon = false, hasPoint = false, areDecimalCommas = true;
            int seen = 0;
            foreach (var (first, end) in lines)
            {
                byte b = bytes[first];
                m_dialect.HasQuotes |= b == '"';
                if (!mayStartWithText && !(b >= '0' && b <= '9') && b != '-' && b != '+' && b != '.' && b != '"')
                    continue;
                seen++;
                for (int i = first; i < end; i++)
                {
                    hasComma |= bytes[i] == ',';
                    hasSemicolon |= bytes[i] == ';';
                    hasPoint |= bytes[i] == '.';
                }
                areDecimalCommas &= AreDecimalCommas(bytes, first, end);
            }
            if (hasSemicolon)
                m_dialect.Separator = (byte)';';
            m_dialect.HasDecimalComma = hasComma && !hasPoint && (hasSemicolon || areDecimalCommas);
            if (hasComma && !hasSemicolon && !m_dialect.HasDecimalComma)
                m_dialect.Separator = (byte)',';
            return seen > 0;
        }

        // Three or more values separated by blanks, none with more than one comma, none with one at an end. Lines
        // without commas are allowed.
        static bool AreDecimalCommas(byte[] bytes, int first, int end)
        {
            int values = 0;
            for (int i = first; i < end;)
            {
                while (i < end && bytes[i] <= ' ')
                    i++;
                int commas = 0, start = i;
                for (; i < end && bytes[i] > ' '; i++)
                    if (bytes[i] == ',')
                        commas++;
                if (i == start)
                    break;
                if (commas > 1 || bytes[start] == ',' || bytes[i - 1] == ',')
                    return false;
                values++;
            }
            return values >= 3 || values == 1 && Array.IndexOf(bytes, (byte)',', first, end - first) < 0;
        }

        bool ReadHead(byte[] head, List<(int First, int End)> lines)
        {
            string[] namesInComment = null;
            int at = 0;
            for (; at < lines.Count; at++)
            {
                var (first, end) = lines[at];
                if (m_dialect.IsComment(head[first]))
                {
                    string comment = TextOf(head, first, end);
                    if (NamesIn(comment.TrimStart('#', '/', '%', '!', ';', ' ')) is { } named &&
                        XyzNames.HavePosition(XyzNames.Of(named, named.Length)))
                        namesInComment = named;
                    HeaderLines++;
                    continue;
                }
                int values = CountValues(head, first, end);
                if (values >= 3)
                    break;
                HeaderLines++;
                if (values == 1 && CountClaimed < 0 && long.TryParse(TextOf(head, first, end), out long claimed) && claimed >= 0)
                {
                    CountClaimed = claimed;
                    continue;
                }
                if (values == 1 && CountClaimed >= 0)
                    throw new PointCloudException(FailureCode.Unsupported, m_source.Path, 0,
                        "this is a PTX file (or text that starts with two numbers, each in a line of its own): not read");
                string[] names = values == 0 ? NamesIn(TextOf(head, first, end)) : null;
                if (names == null || Names != null)
                    return false;
                Names = names;
            }
            if (at == lines.Count)
                return false;

            DataOffset = lines[at].First;
            int columns = CountValues(head, lines[at].First, lines[at].End);
            if (columns > MaxColumns)
                return false;
            if (Names == null && namesInComment != null && namesInComment.Length == columns)
                Names = namesInComment;
            Columns = new XyzColumn[columns];
            for (int i = 0; i < columns; i++)
                Columns[i] = XyzColumn.Empty;
            UnitVectorShares = new double[columns];
            m_unitVectors = new int[columns];
            int all = 0;
            for (; at < lines.Count; at++)
            {
                if (m_dialect.IsComment(head[lines[at].First]))
                    continue;
                all++;
                AddRow(head, lines[at].First, lines[at].End);
            }
            return Rows >= MinRowFraction * all;
        }

        void ReadSegments()
        {
            long from = Math.Min(HeadBytes, m_source.Length), bytes = m_source.Length - from;
            int segments = (int)Math.Min(Segments, bytes / SegmentBytes);
            for (int s = 0; s < segments; s++)
            {
                long offset = from + (long)(bytes / (double)segments * s);
                if (s == segments - 1)
                    offset = m_source.Length - SegmentBytes;
                byte[] segment = m_source.ReadUpTo(offset, SegmentBytes).Bytes;
                int first = 0;
                while (first < segment.Length && !IsLineEnd(segment[first]))
                    first++;
                int end = offset + segment.Length == m_source.Length ? segment.Length : LastLineEnd(segment);
                foreach (var line in LinesOf(segment, first, end))
                    if (!m_dialect.IsComment(segment[line.First]))
                        AddRow(segment, line.First, line.End);
            }
        }

        void AddRow(byte[] bytes, int first, int end)
        {
            m_numbers ??= new DecimalDigits[Columns.Length];
            m_values ??= new double[Columns.Length];
            var values = m_values;
            if (Read(bytes, first, end, m_numbers, values) != Columns.Length)
                return;
            Rows++;
            for (int i = 0; i < Columns.Length; i++)
                if (!double.IsNaN(values[i]))
                    Columns[i].Include(m_numbers[i], values[i]);
            for (int i = 0; i + 3 <= Columns.Length; i++)
                if (Math.Abs(values[i] * values[i] + values[i + 1] * values[i + 1] + values[i + 2] * values[i + 2] - 1) < 0.02)
                    m_unitVectors[i]++;
        }

        int CountValues(byte[] bytes, int first, int end) => Read(bytes, first, end, null, null);

        // The number of values; 0 if one of them is not a number. NaN for a value that is empty or not finite.
        int Read(byte[] bytes, int first, int end, DecimalDigits[] numbers, double[] values)
        {
            byte mark = m_dialect.Separator != 0 ? XyzDialect.Mark : (byte)'\n';
            if (m_line.Length <= end - first)
                m_line = new byte[2 * (end - first + 1)];
            Array.Copy(bytes, first, m_line, 0, end - first);
            m_line[end - first] = (byte)'\n';
            int count = 0;
            fixed (byte* text = m_line)
            {
                m_dialect.Apply(text, end - first);
                byte* p = text;
                bool needsValue = true;
                while (true)
                {
                    while (*p <= ' ' && *p != mark && *p != '\n')
                        p++;
                    if (*p == '\n')
                        return count;
                    double value = double.NaN;
                    var number = default(DecimalDigits);
                    if (*p == mark)
                    {
                        p++;
                        if (!needsValue)
                        {
                            needsValue = true;
                            continue;
                        }
                    }
                    else
                    {
                        byte* again = p;
                        if (m_given != null && count < m_given.Length && m_given[count] == "-")
                        {
                            while (*p > ' ')
                                p++;
                            count++;
                            needsValue = false;
                            continue;
                        }
                        bool isFinite = AsciiNumber.TryDecimal(ref p, out number);
                        if (!AsciiNumber.TryDouble(ref again, out double read))
                            return 0;
                        p = again;
                        value = isFinite ? read : double.NaN;
                        needsValue = false;
                    }
                    if (numbers != null && count < numbers.Length)
                    {
                        numbers[count] = number;
                        values[count] = value;
                    }
                    count++;
                }
            }
        }

        // Null if the line has fewer than three words, or numbers among them.
        string[] NamesIn(string line)
        {
            var separators = m_dialect.Separator == ',' ? new[] { ',' }
                : m_dialect.Separator == ';' ? new[] { ';' } : new[] { ' ', '\t', ',' };
            var names = new List<string>();
            foreach (string word in line.Split(separators))
            {
                string name = word.Trim().Trim('"').Trim();
                if (name.Length == 0 && m_dialect.Separator == 0)
                    continue;
                if (name.Length > 0 && !char.IsLetter(name[0]) && name[0] != '_')
                    return null;
                names.Add(name.Length == 0 ? "-" : name);
            }
            return names.Count >= 3 ? names.ToArray() : null;
        }

        static string TextOf(byte[] bytes, int first, int end) => Encoding.UTF8.GetString(bytes, first, end - first).Trim();
    }
}
