using System;
using System.Collections.Generic;
using System.Globalization;
using System.Text;

namespace FastPoints.Text
{
    // Lines end in LF, CR or CR LF, even mixed; words are separated by any blanks. What may declare something unknown is refused:
    // a property that is left out would shift all that follows it.
    internal sealed class PlyHeaderParser
    {
        public const int MaxHeaderBytes = 1 << 20;
        public const int MaxDeclarations = 1024; // Elements of a file, and properties of an element; files with more are refused.

        static readonly Dictionary<string, AttributeType> s_typeOfName = new Dictionary<string, AttributeType>
        {
            { "char", AttributeType.Int8 }, { "int8", AttributeType.Int8 },
            { "uchar", AttributeType.UInt8 }, { "uint8", AttributeType.UInt8 }, { "bool", AttributeType.UInt8 },
            { "short", AttributeType.Int16 }, { "int16", AttributeType.Int16 },
            { "ushort", AttributeType.UInt16 }, { "uint16", AttributeType.UInt16 },
            { "int", AttributeType.Int32 }, { "int32", AttributeType.Int32 },
            { "uint", AttributeType.UInt32 }, { "uint32", AttributeType.UInt32 },
            { "int64", AttributeType.Int64 }, { "uint64", AttributeType.UInt64 },
            { "float", AttributeType.Float32 }, { "float32", AttributeType.Float32 },
            { "double", AttributeType.Float64 }, { "float64", AttributeType.Float64 },
        };

        static readonly char[] s_blanks = { ' ', '\t', '\v', '\f' };

        readonly string m_path;
        readonly byte[] m_bytes;
        readonly int m_length;
        readonly PlyHeader m_header = new PlyHeader();
        PlyElement m_element;
        bool m_bareCr;

        PlyHeaderParser(string path, byte[] bytes, int length)
        {
            m_path = path;
            m_bytes = bytes;
            m_length = length;
        }

        // "ply" and then a blank or a line end.
        public static bool IsSignature(byte[] start, int length) =>
            length >= 4 && start[0] == 'p' && start[1] == 'l' && start[2] == 'y' && (IsLineEnd(start[3]) || IsBlank(start[3]));

        // Null if the header does not end in these bytes and there may be more (the file is not whole).
        public static PlyHeader Parse(string path, byte[] bytes, int length, bool isWhole) =>
            new PlyHeaderParser(path, bytes, length).Run(isWhole);

        PlyHeader Run(bool isWhole)
        {
            if (!IsSignature(m_bytes, m_length))
            {
                var start = Encoding.ASCII.GetString(m_bytes, 0, Math.Min(m_length, 4));
                throw PointCloudException.Wanted(FailureCode.BadInput, m_path, 0, "PLY signature", "\"ply\" and a line end",
                    m_length == 0 ? "an empty file" : Quote(start));
            }
            int position = 0;
            bool isFirst = true;
            while (true)
            {
                int start = position, end = position;
                while (end < m_length && !IsLineEnd(m_bytes[end]))
                    end++;
                // The byte after a CR is needed as well: it may be the LF that belongs to it.
                if (end + 1 >= m_length && !isWhole)
                    return null;
                string line = Encoding.UTF8.GetString(m_bytes, start, end - start);
                string[] words = line.Split(s_blanks, StringSplitOptions.RemoveEmptyEntries);
                bool isEnd = words.Length > 0 && words[0] == "end_header";
                if (end >= m_length && !isEnd)
                    throw new PointCloudException(FailureCode.Truncated, m_path, m_length, "the header has no end_header line");
                position = AfterLineEnd(end, isEnd);
                if (isEnd)
                {
                    m_header.DataOffset = position;
                    return Checked();
                }
                if (!isFirst && words.Length > 0)
                    Declare(words, line, start);
                isFirst = false;
            }
        }

        // CR LF is one line end. Where the lines before end in a bare CR, so does end_header: a LF after it is the first byte of
        // the data. In all other files CR LF after end_header is two bytes, whatever ends the lines before (assimp's
        // cube_binary_header_with_RN_newline.ply has LF everywhere else).
        int AfterLineEnd(int end, bool isEndHeader)
        {
            if (end >= m_length)
                return m_length;
            bool isCr = m_bytes[end] == '\r';
            bool hasLf = isCr && end + 1 < m_length && m_bytes[end + 1] == '\n';
            if (hasLf && !(isEndHeader && m_bareCr))
                return end + 2;
            m_bareCr |= isCr && !hasLf;
            return end + 1;
        }

        void Declare(string[] words, string line, int offset)
        {
            switch (words[0])
            {
                case "comment":
                case "obj_info":
                    string text = line.Trim().Substring(words[0].Length).Trim();
                    m_header.Comments.Add(new KeyValuePair<string, string>(words[0], text));
                    break;
                case "format":
                    DeclareFormat(words, offset);
                    break;
                case "element":
                    DeclareElement(words, offset);
                    break;
                case "property":
                    DeclareProperty(words, offset);
                    break;
                default:
                    if (!LooksLikeDeclaration(words))
                    {
                        m_header.UnknownKeyword ??= words[0];
                        if (m_header.UnknownLines++ == 0)
                            m_header.UnknownOffset = offset;
                        break;
                    }
                    throw BadInput(offset, "header line", "format, element, property, comment, obj_info or end_header", words[0]);
            }
        }

        // A line with an unknown first word may declare values, without which all others would be shifted: exporters have written
        // remarks without "comment", which may be passed over.
        static bool LooksLikeDeclaration(string[] words) => words.Length == 3 && ulong.TryParse(words[2], out _)
            || words.Length > 1 && (words[1] == "list" || s_typeOfName.ContainsKey(words[1]));

        void DeclareFormat(string[] words, int offset)
        {
            string name = words.Length > 1 ? words[1] : "";
            switch (name)
            {
                case "ascii":
                    m_header.Encoding = PlyEncoding.Ascii;
                    break;
                case "binary_little_endian":
                    m_header.Encoding = PlyEncoding.BinaryLittleEndian;
                    break;
                case "binary_big_endian":
                    m_header.Encoding = PlyEncoding.BinaryBigEndian;
                    break;
                default:
                    throw BadInput(offset, "format", "ascii, binary_little_endian or binary_big_endian", name);
            }
            m_header.Version = words.Length > 2 ? Quote(words[2]).Trim('"') : "";
            m_header.FormatOffset = offset;
        }

        void DeclareElement(string[] words, int offset)
        {
            if (words.Length < 3)
                throw BadInput(offset, "element line", "a name and a count", string.Join(" ", words));
            if (m_header.Elements.Count == MaxDeclarations)
                throw BadInput(offset, "elements", "at most " + MaxDeclarations, "more");
            m_element = new PlyElement { Name = words[1], Count = Count(words[2], offset), LineOffset = offset };
            m_header.Elements.Add(m_element);
        }

        void DeclareProperty(string[] words, int offset)
        {
            if (m_element == null)
                throw BadInput(offset, "property line", "an element line before it", string.Join(" ", words));
            if (m_element.Properties.Count == MaxDeclarations)
                throw BadInput(offset, "properties of element " + Quote(m_element.Name), "at most " + MaxDeclarations, "more");
            bool isList = words.Length > 1 && words[1] == "list";
            if (words.Length < (isList ? 5 : 3))
                throw BadInput(offset, "property line", isList ? "two types and a name" : "a type and a name",
                    string.Join(" ", words));
            var property = new PlyProperty { IsList = isList, LineOffset = offset };
            if (isList)
            {
                property.CountType = Type(words[2], offset);
                if (property.CountType.IsFloat())
                    throw BadInput(offset, "type of a list's count", "an integer type", words[2]);
            }
            property.Type = Type(words[isList ? 3 : 1], offset);
            property.Name = words[isList ? 4 : 2];
            m_element.Properties.Add(property);
        }

        AttributeType Type(string word, int offset)
        {
            if (!s_typeOfName.TryGetValue(word, out var type))
                throw new PointCloudException(FailureCode.Unsupported, m_path, offset, "property type: wanted one of " +
                    "char, uchar, short, ushort, int, uint, float, double, int8 to float64, got " + Quote(word));
            return type;
        }

        // A count that does not fit into a ulong is as absurd as the largest that does.
        ulong Count(string word, int offset)
        {
            foreach (char c in word)
                if (c < '0' || c > '9')
                    throw BadInput(offset, "element count", "a number", word);
            return ulong.TryParse(word, NumberStyles.None, CultureInfo.InvariantCulture, out ulong count)
                ? count
                : ulong.MaxValue;
        }

        PlyHeader Checked()
        {
            if (m_header.Version == null)
                throw new PointCloudException(FailureCode.BadInput, m_path, m_header.DataOffset, "the header has no format line");
            return m_header;
        }

        PointCloudException BadInput(int offset, string field, string wanted, string got) =>
            PointCloudException.Wanted(FailureCode.BadInput, m_path, offset, field, wanted, Quote(got));

        internal static string Quote(string word)
        {
            var text = new StringBuilder("\"");
            for (int i = 0; i < word.Length && i < 32; i++)
                text.Append(char.IsControl(word[i]) ? '?' : word[i]);
            return text.Append(word.Length > 32 ? "...\"" : "\"").ToString();
        }

        static bool IsLineEnd(byte b) => b == '\n' || b == '\r';
        static bool IsBlank(byte b) => b == ' ' || b == '\t' || b == '\v' || b == '\f';
    }

    internal sealed class PlyHeader
    {
        public PlyEncoding Encoding;
        public string Version; // "1.0" in every file that follows the format's only description.

        public long FormatOffset;
        public readonly List<PlyElement> Elements = new List<PlyElement>();
        public readonly List<KeyValuePair<string, string>> Comments = new List<KeyValuePair<string, string>>();

        // First word of the first line that is unknown and declares nothing.
        public string UnknownKeyword;
        public long UnknownOffset;
        public int UnknownLines;
        public long DataOffset;

        public int VertexIndex
        {
            get
            {
                for (int i = 0; i < Elements.Count; i++)
                    if (Elements[i].Name == "vertex")
                        return i;
                return -1;
            }
        }

        public bool IsAscii => Encoding == PlyEncoding.Ascii;
    }

    internal enum PlyEncoding
    {
        Ascii,
        BinaryLittleEndian,
        BinaryBigEndian,
    }

    internal sealed class PlyElement
    {
        public string Name;
        public ulong Count; // As claimed.

        public readonly List<PlyProperty> Properties = new List<PlyProperty>();
        public long LineOffset;

        public bool HasLists
        {
            get
            {
                foreach (var property in Properties)
                    if (property.IsList)
                        return true;
                return false;
            }
        }

        public int FixedBytes
        {
            get
            {
                int bytes = 0;
                foreach (var property in Properties)
                {
                    if (property.IsList)
                        return -1;
                    bytes += property.Type.SizeOf();
                }
                return bytes;
            }
        }

        // One past the file's end for any count that does not fit. Without lists only.
        public long EndOfFixed(long offset, long fileBytes)
        {
            ulong bytes = (ulong)FixedBytes;
            ulong room = offset < fileBytes ? (ulong)(fileBytes - offset) : 0;
            return bytes == 0 || Count <= room / bytes ? offset + (long)(Count * bytes) : fileBytes + 1;
        }
    }

    internal sealed class PlyProperty
    {
        public string Name;
        public AttributeType Type; // Type of the value, or of a list's items.

        public bool IsList;
        public AttributeType CountType; // Type of the number before a list's items: an integer type.

        // Its bytes are blue, green, red and perhaps alpha (PCD).
        public bool IsPackedColor;
        public bool HasAlpha;
        public long LineOffset;
    }
}
