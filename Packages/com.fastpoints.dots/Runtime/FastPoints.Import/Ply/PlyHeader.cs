using System.Collections.Generic;

namespace FastPoints.Ply
{
    /// <summary>The declarations of a PLY header: encoding, elements in the file's order, remarks, and where the data
    /// starts.</summary>
    internal sealed class PlyHeader
    {
        public PlyEncoding Encoding;

        /// <summary>"1.0" in every file that follows the format's only description.</summary>
        public string Version;

        /// <summary>Offset of the format line.</summary>
        public long FormatOffset;

        public readonly List<PlyElement> Elements = new List<PlyElement>();

        /// <summary>The comment and obj_info lines: keyword and text.</summary>
        public readonly List<KeyValuePair<string, string>> Comments = new List<KeyValuePair<string, string>>();

        /// <summary>Lines that are none of the known, and declare nothing: the first one's word, and how many.</summary>
        public string UnknownLine;
        public long UnknownOffset;
        public int UnknownLines;

        /// <summary>First byte after the header.</summary>
        public long DataOffset;

        /// <summary>Index of the first element called vertex, or -1.</summary>
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

    /// <summary>How a PLY file writes its values.</summary>
    internal enum PlyEncoding
    {
        Ascii,
        BinaryLittleEndian,
        BinaryBigEndian,
    }
}
