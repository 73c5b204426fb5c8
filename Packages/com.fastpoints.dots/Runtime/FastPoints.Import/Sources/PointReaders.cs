using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using FastPoints.E57;
using FastPoints.Las;
using FastPoints.Laz;
using FastPoints.Reading;
using FastPoints.Text;

namespace FastPoints.Sources
{
    /// <summary>Opens any point cloud that the package reads, by the file's content and not by its name.</summary>
    public static class PointReaders
    {
        readonly struct Kind
        {
            public readonly byte[] Magic;

            /// <summary>Opens it, or null for a kind that is recognised but not supported.</summary>
            public readonly Func<RandomAccessFile, PointReader> Open;

            public readonly string Name;

            public Kind(string magic, Func<RandomAccessFile, PointReader> open)
            {
                Magic = Encoding.ASCII.GetBytes(magic);
                Open = open;
                Name = null;
            }

            public Kind(string name, params byte[] magic)
            {
                Magic = magic;
                Open = null;
                Name = name;
            }

            public Kind(string name, string magic) : this(name, Encoding.ASCII.GetBytes(magic)) { }
        }

        const int HeadBytes = 64, HashedBytes = 4096;

        static readonly Kind[] s_kinds =
        {
            new Kind("LASF", OpenLas),
            new Kind("ply", PlyReader.Open),
            new Kind("ASTM-E57", E57Reader.Open),
            new Kind("# .PCD", PcdReader.Open),
            new Kind("VERSION ", PcdReader.Open),
            new Kind("FIELDS ", PcdReader.Open),
            new Kind("a zip archive", (byte)'P', (byte)'K', 3, 4),
            new Kind("a gzip file (decompress it first)", 0x1F, 0x8B),
            new Kind("a zstd file (decompress it first)", 0x28, 0xB5, 0x2F, 0xFD),
            new Kind("an HDF5 file", 0x89, (byte)'H', (byte)'D', (byte)'F'),
            new Kind("a PNG picture", 0x89, (byte)'P', (byte)'N', (byte)'G'),
            new Kind("a glTF binary", "glTF"),
            new Kind("a 3D Tiles point cloud", "pnts"),
            new Kind("a Leica PTG file", "PTG"),
        };

        /// <summary>Opens files as one cloud (<see cref="TiledReader"/>); a single one directly. Dispose the reader.</summary>
        /// <exception cref="PointCloudException">The same as for one file.</exception>
        public static PointReader Open(IReadOnlyList<string> paths, ReadOptions options = null) =>
            paths.Count == 1 ? Open(paths[0], options) :
            WithPlacement(TiledReader.Open(paths, path => OpenComplete(path, options)));

        /// <summary>Opens a LAS, LAZ, PLY, PCD, E57, PTX or text file, a Potree octree by its folder or its index in it, or all
        /// clouds that lie in a folder as one. Dispose the reader.</summary>
        /// <exception cref="PointCloudException">There is no such file, no permission, the kind is not supported (Unsupported),
        /// or the header is broken; one line.</exception>
        public static PointReader Open(string path, ReadOptions options = null) =>
            WithPlacement(OpenComplete(path, options));

        static PointReader WithPlacement(PointReader reader)
        {
            CrsText.WarnOfPlacement(reader.Info);
            return reader;
        }

        internal static PointReader OpenComplete(string path, ReadOptions options) =>
            PointReader.Opened(OpenWithoutOverrides(path, options), reader =>
            {
                // Tiles are complete, each by itself.
                if (reader is TiledReader)
                    return;
                options?.Apply(reader.Info);
                CrsText.Complete(reader.Info);
            });

        static PointReader OpenWithoutOverrides(string path, ReadOptions options)
        {
            PointReader OpenTiles() =>
                TiledReader.OpenFolder(path, options?.IsRecursive == true, tile => OpenComplete(tile, options));

            if (!string.IsNullOrEmpty(path) && !SourcePath.IsRemote(path) && Directory.Exists(path))
            {
                // Tiles may lie beside a metadata.json of another kind.
                string index = SourceFolder.FindIndex(path);
                if (index == null)
                    return OpenTiles();
                using var source = RandomAccessFile.Open(index);
                return OpenIndex(SourceJson.Read(source)) is PointReader octree ? WithHeadHash(source, octree) : OpenTiles();
            }
            using (var source = RandomAccessFile.Open(path))
                return WithHeadHash(source, OpenFile(source, options));
        }

        static PointReader OpenFile(RandomAccessFile source, ReadOptions options)
        {
            byte[] head = source.ReadUpTo(0, HeadBytes).Bytes;
            if (SourceJson.Is(head))
            {
                var index = SourceJson.Read(source);
                return OpenIndex(index) ?? throw NoOctree(index);
            }
            foreach (var kind in s_kinds)
            {
                if (!StartsWith(head, kind.Magic))
                    continue;
                if (kind.Open != null)
                    return kind.Open(source);
                throw new PointCloudException(FailureCode.Unsupported, source.Path, 0,
                    "this is " + kind.Name + ": wanted LAS, LAZ, PLY, PCD, E57 or Potree");
            }
            return (PointReader)PtxReader.Open(source) ?? XyzReader.Open(source, options?.TextColumns) ??
                throw new PointCloudException(FailureCode.Unsupported, source.Path, 0,
                    "no known point cloud format: wanted LAS (LASF), PLY (ply), PCD, E57 (ASTM-E57), or lines of numbers, " +
                    "got " + Describe(head));
        }

        static unsafe PointReader WithHeadHash(RandomAccessFile source, PointReader reader) =>
            PointReader.Opened(reader, opened =>
            {
                byte[] head = source.ReadUpTo(0, HashedBytes).Bytes;
                fixed (byte* first = head)
                    opened.Info.HeadHash = ContentHash.Of(first, head.Length);
            });

        static PointReader OpenLas(RandomAccessFile source)
        {
            var las = LasFile.Read(source);
            return !las.Header.IsCompressed ? LasReader.OpenUncompressed(las, source)
                : CopcReader.TryOpen(las, source) ?? LazReader.Open(las, source);
        }

        // Null for JSON that is no octree's index.
        static PointReader OpenIndex(JsonMembers index)
        {
            if (index.IsObject("hierarchy") && index.Has("encoding"))
                return Potree2Reader.Open(index);
            if (index.Has("octreeDir") || index.Has("pointAttributes"))
                return Potree1Reader.Open(index);
            if (index.Has("hierarchyType") || index.IsList("schema") && index.Has("dataType"))
                return EptReader.Open(index);
            if (index.IsText("format") && index.Text("format") == "fastpoints")
                throw new PointCloudException(FailureCode.Unsupported, index.Path, 0,
                    "this is a converted cloud already, not a source: draw it, or convert what it was made from");
            return null;
        }

        static PointCloudException NoOctree(JsonMembers index) =>
            new PointCloudException(FailureCode.Unsupported, index.Path, 0,
                "this is JSON, but no point cloud's: wanted Potree's metadata.json or cloud.js, got the members "
                    + string.Join(", ", index.Names));

        static bool StartsWith(byte[] head, byte[] magic)
        {
            if (head.Length < magic.Length)
                return false;
            for (int i = 0; i < magic.Length; i++)
                if (head[i] != magic[i])
                    return false;
            return true;
        }

        // Text, or hexadecimal if they are not text.
        static string Describe(byte[] head)
        {
            int count = Math.Min(head.Length, 16);
            var text = new StringBuilder("text \"");
            for (int i = 0; i < count; i++)
            {
                if (head[i] == '\r' || head[i] == '\n')
                    break;
                if (head[i] != '\t' && (head[i] < 32 || head[i] > 126))
                    return "bytes " + BitConverter.ToString(head, 0, count);
                text.Append((char)head[i]);
            }
            return text.Append('"').ToString();
        }
    }

    /// <summary>Overrides for facts that files get wrong or lack. All are optional.</summary>
    public sealed class ReadOptions
    {
        /// <summary>Names of the columns of a text file, in their order: x, y, z, i, r, g, b, nx, ny, nz or any other; "-" leaves
        /// a column out. If null, the file's own names apply, or they are guessed.</summary>
        public string[] TextColumns;

        /// <summary>The coordinate system in place of what files say: <c>EPSG:2229</c>, <c>EPSG:2229+5703</c>, well-known text,
        /// or a PROJ string. Points are not moved.</summary>
        public string CoordinateSystem;

        /// <summary>Metres of a unit along all axes, instead of the files' unit; 0 for theirs.</summary>
        public double MetresPerUnit;

        /// <summary>Subfolders are searched, too; an octree in one of them is a tile.</summary>
        public bool IsRecursive;

        internal void Apply(SourceInfo info)
        {
            if (CoordinateSystem != null)
            {
                info.Crs = new CoordinateSystem();
                info.IsCrsOverridden = true;
                if (!CrsText.Read(CoordinateSystem, info.Crs))
                    throw new PointCloudException(FailureCode.BadInput, info.Path, -1, "wanted a coordinate system such as " +
                        "EPSG:2229, got " + CoordinateSystem);
            }
            info.IsUnitOverridden = MetresPerUnit > 0;
            if (info.IsUnitOverridden)
                (info.Crs.MetresPerUnit, info.Crs.VerticalMetresPerUnit) = (MetresPerUnit, MetresPerUnit);
        }
    }
}
