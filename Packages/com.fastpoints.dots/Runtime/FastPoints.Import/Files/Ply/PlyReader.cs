using System;
using System.Collections.Generic;
using FastPoints.Base;
using FastPoints.Points;
using Unity.IO.LowLevel.Unsafe;

namespace FastPoints.Files
{
    /// <summary>Reads the vertices of a PLY file, ascii or binary, as points: each scalar property is an attribute of its own
    /// type, under its usual name (<see cref="PlyNames"/>) or the file's. Lists and all other elements are skipped.</summary>
    /// <remarks>If a file breaks off or has a bad value, the points before it are read and a warning says where. A file that
    /// claims vertices but has no readable ones is refused. Coordinates that are not finite are kept.</remarks>
    internal abstract class PlyReader : PointReader
    {
        const int FirstHeaderBytes = 16 << 10;

        FileHandle m_file;
        readonly HashSet<int> m_brokenBlocks = new HashSet<int>();
        bool m_isOpen;
        int m_brokenWarning = -1;
        string m_firstBreak;
        long m_pointsLost;
        bool m_hasToldMisfits;
        bool m_hasToldExtraValues;

        private protected PlyReader(PlyHeader header, SourceInfo info)
        {
            Header = header;
            Info = info;
            Vertex = header.Elements[header.VertexIndex];
            Names = PlyNames.Of(Vertex);
        }

        public PlyHeader Header { get; }

        private protected PlyElement Vertex { get; }

        /// <summary>Attribute name of each property of the vertex element; null for lists.</summary>
        private protected string[] Names { get; }

        internal FileHandle File
        {
            get
            {
                if (!m_isOpen)
                    m_file = AsyncReadManager.OpenFileAsync(Info.Path);
                m_isOpen = true;
                return m_file;
            }
        }

        /// <inheritdoc cref="Open(FileSource)"/>
        public static PlyReader Open(string path)
        {
            using (var source = FileSource.Open(path))
                return Open(source);
        }

        /// <summary>Opens a PLY file. Only its header is read.</summary>
        /// <exception cref="PointCloudException">The header is invalid or has no vertices with x, y and z, or the file claims
        /// vertices and has none.</exception>
        public static PlyReader Open(FileSource source)
        {
            var header = ReadHeader(source);
            if (header.VertexIndex < 0)
                throw new PointCloudException(FailureCode.BadInput, source.Path, header.DataOffset,
                    "the header has no vertex element");
            var info = Describe(source, header);
            if (header.IsAscii)
                return new PlyAsciiReader(header, info);
            return header.Elements[header.VertexIndex].HasLists
                ? (PlyReader)new PlyListReader(header, info)
                : new PlyFixedReader(header, info);
        }

        static PlyHeader ReadHeader(FileSource source)
        {
            for (int length = FirstHeaderBytes; ; length *= 4)
            {
                length = Math.Min(length, PlyHeaderParser.MaxHeaderBytes);
                byte[] bytes = source.ReadAtMost(0, length).Bytes;
                var header = PlyHeaderParser.Parse(source.Path, bytes, bytes.Length, bytes.Length == source.Length);
                if (header != null)
                    return header;
                if (length == PlyHeaderParser.MaxHeaderBytes)
                    throw PointCloudException.Wanted(FailureCode.BadInput, source.Path, length, "length of the header",
                        "at most " + PlyHeaderParser.MaxHeaderBytes + " bytes", "more");
            }
        }

        static SourceInfo Describe(FileSource source, PlyHeader header)
        {
            var vertex = header.Elements[header.VertexIndex];
            var info = new SourceInfo
            {
                Path = source.Path,
                FileBytes = source.Length,
                Format = "PLY",
                Version = header.Version,
                PointsClaimed = vertex.Count,
                RecordBytes = header.IsAscii ? 0 : Math.Max(vertex.FixedBytes, 0),
            };
            if (header.Version != "1.0")
                info.Warn(header.FormatOffset, "version: wanted 1.0, got \"" + header.Version + "\"; read as 1.0");

            var names = PlyNames.Of(vertex);
            var attributes = new List<PointAttribute>();
            for (int i = 0; i < names.Length; i++)
                if (names[i] != null)
                    attributes.Add(new PointAttribute(names[i], vertex.Properties[i].Type));
            info.Schema = new PointSchema(attributes);
            foreach (string axis in new[] { AttributeNames.X, AttributeNames.Y, AttributeNames.Z })
                if (!info.Schema.Has(axis))
                    throw new PointCloudException(FailureCode.BadInput, source.Path, vertex.LineOffset,
                        "the vertex element has no property " + axis.ToLowerInvariant());

            info.Fact("encoding", header.IsAscii ? "ascii"
                : header.Encoding == PlyEncoding.BinaryBigEndian ? "binary, big endian" : "binary, little endian");
            foreach (var element in header.Elements)
                info.Fact("element " + element.Name, element.Count + (element.HasLists ? ", with lists" : ""));
            foreach (var remark in header.Remarks)
                info.Fact(remark.Key, remark.Value);
            for (int i = header.VertexIndex + 1; i < header.Elements.Count; i++)
                if (header.Elements[i].Name == "vertex")
                    info.Warn(header.Elements[i].LineOffset, "a second vertex element: it is left out");
            return info;
        }

        public override void CloseFile()
        {
            if (!m_isOpen)
                return;
            m_isOpen = false;
            m_file.Close().Complete();
        }

        /// <summary>Settles the number of vertices: fewer than claimed is a warning, none at all a failure.</summary>
        private protected void SettlePoints(long found, long endOffset, string why)
        {
            Info.PointsReadable = found;
            if (Vertex.Count == (ulong)found)
                return;
            string text = "vertices: wanted " + Vertex.Count + ", got " + found + (why != null ? ": " + why : "");
            if (found == 0)
                throw new PointCloudException(FailureCode.Truncated, Info.Path, endOffset, text);
            Info.Warn(endOffset, text);
        }

        /// <summary>Warns about a range that broke off. Its points are kept; the file's first range must have some.</summary>
        internal void WarnBroken(BlockRange range, DecodeResult result)
        {
            string text = PlyError.Text(result.Error);
            if (BlocksAreKnown && range.Block == 0 && range.First == 0 && result.Points == 0)
                throw new PointCloudException(FailureCode.BadInput, Info.Path, result.ErrorOffset,
                    "in the first vertex: " + text);
            if (!m_brokenBlocks.Add(range.Block))
                return;
            m_pointsLost += range.Count - result.Points;
            if (m_brokenWarning < 0)
            {
                m_brokenWarning = Info.Warnings.Count;
                Info.Warn(result.ErrorOffset, "");
            }
            var first = Info.Warnings[m_brokenWarning];
            if (m_brokenBlocks.Count == 1)
                m_firstBreak = text;
            Info.Warnings[m_brokenWarning] = new CloudWarning(first.Path, first.ByteOffset, m_firstBreak +
                ": the vertices from here to the end of the block are left out (" + m_pointsLost + " vertices in " +
                m_brokenBlocks.Count + " blocks so far)");
        }

        /// <summary>Forgets broken ranges when other blocks replace the known ones.</summary>
        private protected void ForgetBroken()
        {
            m_brokenBlocks.Clear();
            m_pointsLost = 0;
        }

        /// <summary>Reports, once for each file, values that were changed or skipped.</summary>
        internal void WarnAnomalies(in PlyAnomalies anomalies)
        {
            if (anomalies.Misfits > 0 && !m_hasToldMisfits)
            {
                m_hasToldMisfits = true;
                Info.Warn(anomalies.FirstMisfitOffset, "a value that its property's integer type cannot hold: the nearest " +
                    "that it can was taken, without fraction (" + anomalies.Misfits +
                    " in this block; later blocks are not counted)");
            }
            if (anomalies.LinesWithExtraValues > 0 && !m_hasToldExtraValues)
            {
                m_hasToldExtraValues = true;
                Info.Warn(anomalies.FirstExtraOffset,
                    "more values in the line than the vertex has properties: they are left out (" +
                    anomalies.LinesWithExtraValues + " lines in this block; later blocks are not counted)");
            }
        }
    }
}
