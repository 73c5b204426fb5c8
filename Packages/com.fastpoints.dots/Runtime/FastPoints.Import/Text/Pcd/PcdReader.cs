using System;
using System.Collections.Generic;
using System.Globalization;
using System.Text;
using FastPoints.Reading;

namespace FastPoints.Text
{
    // The header (Point Cloud Library, version 0.7): lines of a keyword and its words, up to DATA.
    sealed class PcdHeader
    {
        public const int MaxBytes = 64 << 10;
        const int MaxValues = 4096; // Files with more values a point are refused.

        readonly string m_path;
        readonly Dictionary<string, string[]> m_words = new Dictionary<string, string[]>();
        readonly Dictionary<string, int> m_offsets = new Dictionary<string, int>();

        PcdHeader(string path) => m_path = path;

        public readonly List<PcdField> Fields = new List<PcdField>();
        public string UnknownKeyword;
        public int UnknownLines;
        public int UnknownOffset;

        public ulong Points;
        public ulong? OrganizedPoints;
        public string Data;
        public long DataOffset;

        public string this[string keyword] => m_words.TryGetValue(keyword, out var words) ? string.Join(" ", words) : null;

        public static PcdHeader Read(RandomAccessFile source)
        {
            byte[] bytes = source.ReadUpTo(0, MaxBytes).Bytes;
            var header = new PcdHeader(source.Path);
            for (int at = 0; header.Data == null;)
            {
                int end = Array.IndexOf(bytes, (byte)'\n', at);
                if (end < 0)
                    throw new PointCloudException(FailureCode.Truncated, source.Path, at, "the header has no DATA line");
                header.AddLine(Encoding.ASCII.GetString(bytes, at, end - at).Trim(), at);
                header.DataOffset = at = end + 1;
            }
            header.ReadFields();
            return header;
        }

        void AddLine(string line, int offset)
        {
            if (line.Length == 0 || line[0] == '#')
                return;
            string[] words = line.Split((char[])null, StringSplitOptions.RemoveEmptyEntries);
            string keyword = words[0];
            if (Array.IndexOf(s_keywords, keyword) < 0)
            {
                UnknownKeyword ??= keyword;
                if (UnknownLines++ == 0)
                    UnknownOffset = offset;
                return;
            }
            m_offsets[keyword] = offset;
            m_words[keyword] = words.AsSpan(1).ToArray();
            if (keyword == "DATA")
                Data = this["DATA"];
        }

        static readonly string[] s_keywords =
        {
            "VERSION", "FIELDS", "COLUMNS", "SIZE", "TYPE", "COUNT", "WIDTH", "HEIGHT", "VIEWPOINT", "POINTS", "DATA",
        };

        void ReadFields()
        {
            string[] names = m_words.ContainsKey("FIELDS") ? m_words["FIELDS"]
                : m_words.TryGetValue("COLUMNS", out var columns) ? columns
                : throw new PointCloudException(FailureCode.BadInput, m_path, -1, "the header has no FIELDS line");
            string[] sizes = Words("SIZE", names.Length), types = Words("TYPE", names.Length);
            string[] counts = m_words.ContainsKey("COUNT") ? Words("COUNT", names.Length) : null;
            int values = 0;
            for (int i = 0; i < names.Length; i++)
            {
                ulong count = counts == null ? 1 : Number("COUNT", counts[i]);
                if (count > MaxValues || (values += (int)count) > MaxValues)
                    throw Bad("COUNT", "at most " + MaxValues + " values a point", "more");
                var type = TypeOf(types[i], sizes[i]);
                // Text has its digits whatever the field's type: as 32 bits, coordinates far from 0 would lose half a metre.
                if (type == AttributeType.Float32 && Data == "ascii" && (names[i] == "x" || names[i] == "y" || names[i] == "z"))
                    type = AttributeType.Float64;
                Fields.Add(new PcdField { Name = names[i], Type = type, Count = (int)count });
            }
            if (m_words.ContainsKey("WIDTH") && m_words.ContainsKey("HEIGHT"))
            {
                ulong width = Number("WIDTH", Words("WIDTH", 1)[0]), height = Number("HEIGHT", Words("HEIGHT", 1)[0]);
                OrganizedPoints = height != 0 && width > ulong.MaxValue / height ? ulong.MaxValue : width * height;
            }
            Points = m_words.ContainsKey("POINTS") ? Number("POINTS", Words("POINTS", 1)[0])
                : OrganizedPoints ?? throw new PointCloudException(FailureCode.BadInput, m_path, -1,
                    "the header says neither POINTS nor WIDTH and HEIGHT");
        }

        AttributeType TypeOf(string type, string size) => (type + size) switch
        {
            "I1" => AttributeType.Int8,
            "I2" => AttributeType.Int16,
            "I4" => AttributeType.Int32,
            "I8" => AttributeType.Int64,
            "U1" => AttributeType.UInt8,
            "U2" => AttributeType.UInt16,
            "U4" => AttributeType.UInt32,
            "U8" => AttributeType.UInt64,
            "F4" => AttributeType.Float32,
            "F8" => AttributeType.Float64,
            _ => throw Bad("TYPE", "I or U of 1, 2, 4 or 8 bytes, or F of 4 or 8", PlyHeaderParser.Quote(type + size)),
        };

        string[] Words(string keyword, int count)
        {
            if (!m_words.TryGetValue(keyword, out var words))
                throw new PointCloudException(FailureCode.BadInput, m_path, -1, "the header has no " + keyword + " line");
            return words.Length == count ? words : throw Bad(keyword, count + " words", NumberText.Of(words.Length));
        }

        ulong Number(string keyword, string word) =>
            ulong.TryParse(word, NumberStyles.None, CultureInfo.InvariantCulture, out ulong number) ? number
                : throw Bad(keyword, "a whole number", PlyHeaderParser.Quote(word));

        PointCloudException Bad(string keyword, string wanted, string got) =>
            PointCloudException.Wanted(FailureCode.BadInput, m_path, m_offsets[keyword], keyword, wanted, got);
    }

    sealed class PcdField
    {
        public string Name;
        public AttributeType Type;
        public int Count;

        public int Bytes => Count * Type.SizeOf();

        public bool IsPackedColor => Count == 1 && Type.SizeOf() == 4 && (Name == "rgb" || Name == "rgba");
    }

    // The Point Cloud Library's files: ascii and binary ones as PLY files with another header, binary_compressed ones by
    // PcdLzfReader. Packed colours become Red, Green and Blue.
    static class PcdReader
    {
        const int PageBytes = 4096;

        public static PointReader Open(RandomAccessFile source)
        {
            var pcd = PcdHeader.Read(source);
            var vertex = new PlyElement { Name = "vertex", Count = pcd.Points };
            foreach (var field in pcd.Fields)
                for (int i = 0; i < field.Count; i++)
                    vertex.Properties.Add(new PlyProperty
                    {
                        Name = field.Count == 1 ? field.Name : field.Name + "[" + NumberText.Of(i) + "]",
                        Type = field.Type,
                        IsPackedColor = field.IsPackedColor,
                        HasAlpha = field.Name == "rgba",
                    });
            var header = new PlyHeader
            {
                Encoding = pcd.Data == "ascii" ? PlyEncoding.Ascii : PlyEncoding.BinaryLittleEndian,
                DataOffset = pcd.DataOffset,
            };
            header.Elements.Add(vertex);
            string[] names = PlyNames.Of(vertex);
            for (int i = 0; i < names.Length; i++)
                if (vertex.Properties[i].IsPackedColor || vertex.Properties[i].Name.StartsWith("_", StringComparison.Ordinal))
                    names[i] = null;
            var info = new SourceInfo
            {
                Path = source.Path,
                FileBytes = source.Length,
                Format = "PCD",
                Version = pcd["VERSION"] is { } version && version.StartsWith(".", StringComparison.Ordinal) ? "0" + version
                    : pcd["VERSION"],
                PointsClaimed = pcd.Points,
                RecordBytes = pcd.Data == "binary" ? vertex.FixedBytes : 0,
            };
            var ply = new PlyFile(header, info, names);
            info.Schema = ply.RecordFields().ToSchema();
            foreach (string axis in new[] { AttributeNames.X, AttributeNames.Y, AttributeNames.Z })
                if (!info.Schema.Has(axis))
                    throw new PointCloudException(FailureCode.BadInput, source.Path, -1,
                        "the points have no field " + axis.ToLowerInvariant());
            Describe(pcd, info);
            int padding = pcd.Data == "binary" ? PaddingOf(source, vertex.EndOfFixed(pcd.DataOffset, source.Length)) : 0;
            if (padding > 0)
            {
                var page = new PlyElement { Name = "padding", Count = (ulong)padding };
                page.Properties.Add(new PlyProperty { Type = AttributeType.UInt8 });
                header.Elements.Add(page);
            }
            return pcd.Data switch
            {
                "ascii" => new PlyAsciiReader(ply),
                "binary" => new PlyFixedReader(ply),
                "binary_compressed" => new PcdLzfReader(source, pcd, ply),
                _ => throw PointCloudException.Wanted(FailureCode.Unsupported, source.Path, pcd.DataOffset, "DATA",
                    "ascii, binary or binary_compressed", PlyHeaderParser.Quote(pcd.Data)),
            };
        }

        // Zeros up to the end of a page, which the Point Cloud Library writes after binary points; 0 if there is anything else.
        static int PaddingOf(RandomAccessFile source, long offset)
        {
            if (offset >= source.Length || source.Length - offset >= PageBytes)
                return 0;
            byte[] bytes = source.ReadUpTo(offset, PageBytes).Bytes;
            return Array.TrueForAll(bytes, b => b == 0) ? bytes.Length : 0;
        }

        static void Describe(PcdHeader pcd, SourceInfo info)
        {
            info.AddFact("encoding", pcd.Data);
            foreach (string keyword in new[] { "WIDTH", "HEIGHT", "VIEWPOINT" })
                if (pcd[keyword] is { } words)
                    info.AddFact(keyword.ToLowerInvariant(), words);
            info.UnexportableFacts = pcd["VIEWPOINT"] is { } view && view != "0 0 0 1 0 0 0" ? "the viewpoint" : null;
            if (pcd["HEIGHT"] is { } height && height != "1")
                info.Losses.Add(new Loss("the scan's grid", info.Path, "points are kept without their neighbours in it"));
            if (pcd.OrganizedPoints is { } organizedPoints && organizedPoints != pcd.Points)
                info.Warn(0, "WIDTH times HEIGHT is " + NumberText.Of(organizedPoints) + ", POINTS " + NumberText.Of(pcd.Points) +
                    ": the latter is believed");
            if (pcd.UnknownLines > 0)
                info.Warn(pcd.UnknownOffset,
                    "header line: wanted a keyword of PCD, got " + PlyHeaderParser.Quote(pcd.UnknownKeyword) +
                    " (" + NumberText.Of(pcd.UnknownLines) + " such lines): left out");
        }
    }
}
