using FastPoints.Core;
using FastPoints.Reading;

namespace FastPoints.Ply
{
    /// <summary>Reads the vertices of a PLY file, ascii or binary, as points: each scalar property is an attribute of its own
    /// type, under its usual name (<see cref="PlyNames"/>) or the file's. Lists and all other elements are skipped.</summary>
    /// <remarks>If a file breaks off or has a bad value, the points before it are read and a warning says where. A file that
    /// claims vertices but has no readable ones is refused. Coordinates that are not finite are kept.</remarks>
    static class PlyReader
    {
        /// <inheritdoc cref="Open(FileSource)"/>
        public static PointReader Open(string path)
        {
            using var source = FileSource.Open(path);
            return Open(source);
        }

        /// <summary>Opens a PLY file. Only its header is read.</summary>
        /// <exception cref="Base.PointCloudException">The header is invalid or has no vertices with x, y and z, or the file
        /// claims vertices and has none.</exception>
        public static PointReader Open(FileSource source)
        {
            var ply = PlyFile.Read(source);
            return ply.Header.IsAscii ? new PlyAsciiReader(ply)
                : ply.Vertex.HasLists ? (PointReader)new PlyListReader(ply) : new PlyFixedReader(ply);
        }
    }
}
