using System;
using FastPoints.Core;
using FastPoints.Ply;
using FastPoints.Reading;

namespace FastPoints.Text
{
    // The Point Cloud Library's files: ascii and binary ones as PLY files with another header, binary_compressed ones by
    // PcdLzfReader. Packed colours become Red, Green and Blue.
    static class PcdReader
    {
        const int PageBytes = 4096;

        // Only the header is read.
        public static PointReader Open(FileSource source)
        {
            var pcd = PcdHeader.Read(source);
            var vertex = new PlyElement { Name = "vertex", Count = pcd.Points };
            foreach (var field in pcd.Fields)
                for (int i = 0; i < field.Count; i++)
                    vertex.Properties.Add(new PlyProperty
                    {
                        Name = field.Count == 1 ? field.Name : field.Name + "[" + NumberText.Of(i) + "]",
                        Type = field.Type,
                        IsColor = field.IsColor,
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
                if (vertex.Properties[i].IsColor || vertex.Properties[i].Name.StartsWith("_", StringComparison.Ordinal))
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

        // Zeros up to the end of a page, which the Point Cloud Library puts behind binary points; 0 if anything else is there.
        static int PaddingOf(FileSource source, long offset)
        {
            if (offset >= source.Length || source.Length - offset >= PageBytes)
                return 0;
            byte[] bytes = source.ReadUpTo(offset, PageBytes).Bytes;
            return Array.TrueForAll(bytes, b => b == 0) ? bytes.Length : 0;
        }

        static void Describe(PcdHeader pcd, SourceInfo info)
        {
            info.Fact("encoding", pcd.Data);
            foreach (string keyword in new[] { "WIDTH", "HEIGHT", "VIEWPOINT" })
                if (pcd[keyword] is { } words)
                    info.Fact(keyword.ToLowerInvariant(), words);
            if (pcd.Places is { } places && places != pcd.Points)
                info.Warn(0, "WIDTH times HEIGHT is " + NumberText.Of(places) + ", POINTS " + NumberText.Of(pcd.Points) +
                    ": the latter is believed");
            if (pcd.UnknownLines > 0)
                info.Warn(pcd.UnknownOffset,
                    "header line: wanted a keyword of PCD, got " + PlyHeaderParser.Quote(pcd.UnknownLine) +
                    " (" + NumberText.Of(pcd.UnknownLines) + " such lines): left out");
        }
    }
}
