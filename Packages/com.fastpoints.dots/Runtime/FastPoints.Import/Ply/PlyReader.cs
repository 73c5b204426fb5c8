using FastPoints.Core;
using FastPoints.Reading;

namespace FastPoints.Ply
{
    // The vertices of a PLY file, ascii or binary, as points: each scalar property is an attribute of its own type, under its
    // usual name (PlyNames) or the file's. Lists and all other elements are skipped. If a file breaks off or has a bad value, the
    // points before it are read and a warning says where. Coordinates that are not finite are kept.
    static class PlyReader
    {
        public static PointReader Open(string path)
        {
            using var source = FileSource.Open(path);
            return Open(source);
        }

        // Only the header is read.
        public static PointReader Open(FileSource source)
        {
            var ply = PlyFile.Read(source);
            return ply.Header.IsAscii ? new PlyAsciiReader(ply)
                : ply.Vertex.HasLists ? (PointReader)new PlyListReader(ply) : new PlyFixedReader(ply);
        }
    }
}
