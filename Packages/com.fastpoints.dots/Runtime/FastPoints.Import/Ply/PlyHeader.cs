using System.Collections.Generic;

namespace FastPoints.Ply
{
    internal sealed class PlyHeader
    {
        public PlyEncoding Encoding;

        // "1.0" in every file that follows the format's only description.
        public string Version;

        public long FormatOffset;

        public readonly List<PlyElement> Elements = new List<PlyElement>();

        // Keyword and text of comment and obj_info lines.
        public readonly List<KeyValuePair<string, string>> Comments = new List<KeyValuePair<string, string>>();

        // The word of the first line that is none of the known, and declares nothing.
        public string UnknownLine;
        public long UnknownOffset;
        public int UnknownLines;
        public long DataOffset;

        // Of the first element called vertex, or -1.
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
}
