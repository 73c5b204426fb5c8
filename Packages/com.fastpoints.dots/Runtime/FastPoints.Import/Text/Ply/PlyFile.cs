using System;
using System.Collections.Generic;
using FastPoints.Reading;

namespace FastPoints.Text
{
    sealed class PlyFile
    {
        const int FirstHeaderBytes = 16 << 10;

        readonly bool m_isPcd;
        readonly HashSet<int> m_brokenBlocks = new HashSet<int>();
        readonly RunningWarning m_pointsLost = new RunningWarning();
        string m_firstFault;
        bool m_hasReportedInexact;
        bool m_hasReportedExtraValues;

        public PlyFile(PlyHeader header, SourceInfo info, string[] names)
        {
            Header = header;
            Info = info;
            Vertex = header.Elements[header.VertexIndex];
            Names = names;
            m_isPcd = info.Format == "PCD";
            Handle = new SourceHandle(info.Path);
        }

        public PlyHeader Header { get; }
        public SourceInfo Info { get; }
        public PlyElement Vertex { get; }

        public string[] Names { get; } // Null for lists, packed colours and padding.

        public SourceHandle Handle { get; }
        public bool IsBigEndian => Header.Encoding == PlyEncoding.BinaryBigEndian;

        public static PlyFile Read(RandomAccessFile source)
        {
            var header = ReadHeader(source);
            if (header.VertexIndex < 0)
                throw new PointCloudException(FailureCode.BadInput, source.Path, header.DataOffset,
                    "the header has no vertex element");
            return new PlyFile(header, Describe(source, header), PlyNames.Of(header.Elements[header.VertexIndex]));
        }

        public PointFields RecordFields()
        {
            var fields = new PointFields();
            int at = 0;
            for (int i = 0; i < Names.Length; i++)
            {
                foreach (var field in FieldsOf(i, at))
                    fields.Add(field);
                at += Vertex.Properties[i].Type.SizeOf();
            }
            return fields;
        }

        // One, none, or those of a packed colour; at: the property's offset.
        public IEnumerable<PointField> FieldsOf(int property, int at)
        {
            var declared = Vertex.Properties[property];
            if (Names[property] != null)
                yield return new PointField(Names[property], declared.Type, at);
            for (int i = 0; declared.IsPackedColor && i < (declared.HasAlpha ? 4 : 3); i++)
                yield return new PointField(PlyPlan.ColorNames[i], AttributeType.UInt8, at + (i < 3 ? 2 - i : i));
        }

        static PlyHeader ReadHeader(RandomAccessFile source)
        {
            for (int length = FirstHeaderBytes; ; length *= 4)
            {
                length = Math.Min(length, PlyHeaderParser.MaxHeaderBytes);
                byte[] bytes = source.ReadUpTo(0, length).Bytes;
                var header = PlyHeaderParser.Parse(source.Path, bytes, bytes.Length, bytes.Length == source.Length);
                if (header != null)
                    return header;
                if (length == PlyHeaderParser.MaxHeaderBytes)
                    throw PointCloudException.Wanted(FailureCode.BadInput, source.Path, length, "length of the header",
                        "at most " + PlyHeaderParser.MaxHeaderBytes + " bytes", "more");
            }
        }

        static SourceInfo Describe(RandomAccessFile source, PlyHeader header)
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

            info.AddFact("encoding", header.IsAscii ? "ascii"
                : header.Encoding == PlyEncoding.BinaryBigEndian ? "binary, big endian" : "binary, little endian");
            foreach (var element in header.Elements)
            {
                info.AddFact("element " + element.Name, element.Count + (element.HasLists ? ", with lists" : ""));
                if (element != vertex || element.HasLists)
                    info.Losses.Add(new Loss((element == vertex ? "lists of " : "") + "element " + element.Name, info.Path,
                        "it is no point"));
            }
            info.UnexportableFacts = header.Comments.Count > 0 ? "comments" : null;
            foreach (var comment in header.Comments)
                info.AddFact(comment.Key, comment.Value);
            if (header.UnknownLines > 0)
                info.Warn(header.UnknownOffset,
                    "header line: wanted format, element, property, comment, obj_info or end_header, " +
                    "got " + PlyHeaderParser.Quote(header.UnknownKeyword) + " (" + header.UnknownLines +
                    " such lines): left out");
            for (int i = header.VertexIndex + 1; i < header.Elements.Count; i++)
                if (header.Elements[i].Name == "vertex")
                    info.Warn(header.Elements[i].LineOffset, "a second vertex element: it is left out");
            return info;
        }

        // Fewer vertices than claimed is a warning, none at all a failure.
        public void SetPointCount(long found, long endOffset, string reason)
        {
            Info.PointsReadable = found;
            if (Vertex.Count == (ulong)found)
                return;
            string text = (m_isPcd ? "points" : "vertices") + ": wanted " + Vertex.Count + ", got " + found +
                (reason != null ? ": " + reason : "");
            if (found == 0)
                throw new PointCloudException(FailureCode.Truncated, Info.Path, endOffset, text);
            Info.Warn(endOffset, text);
        }

        // The points before the fault are kept; the file's first range must have some.
        public void WarnBroken(BlockRange range, DecodeResult result, bool areBlocksKnown)
        {
            string text = PlyError.Text(result.Error);
            if (areBlocksKnown && range.Block == 0 && range.First == 0 && result.Points == 0)
                throw new PointCloudException(FailureCode.BadInput, Info.Path, result.ErrorOffset,
                    "in the first " + (m_isPcd ? "point: " : "vertex: ") + text);
            if (!m_brokenBlocks.Add(range.Block))
                return;
            if (m_brokenBlocks.Count == 1)
                m_firstFault = text;
            string points = m_isPcd ? "points" : "vertices";
            m_pointsLost.Add(Info, range.Count - result.Points, result.ErrorOffset, lost => m_firstFault + ": the " + points +
                " from here to the end of the block are left out (" + lost + " " + points + " in " + m_brokenBlocks.Count +
                " blocks so far)");
        }

        // Other blocks replace the known ones.
        public void ForgetBroken()
        {
            m_brokenBlocks.Clear();
            m_pointsLost.Reset();
        }

        // Once for each file: values that were changed or skipped.
        public void WarnAnomalies(in PlyAnomalies anomalies)
        {
            if (anomalies.Inexact > 0 && !m_hasReportedInexact)
            {
                m_hasReportedInexact = true;
                Info.Warn(anomalies.FirstInexactOffset, "a value that its property's integer type cannot hold: the nearest " +
                    "that it can was taken, without fraction (" + anomalies.Inexact +
                    " in this block; later blocks are not counted)");
            }
            if (anomalies.LinesWithExtraValues > 0 && !m_hasReportedExtraValues)
            {
                m_hasReportedExtraValues = true;
                Info.Warn(anomalies.FirstExtraOffset,
                    "more values in the line than the vertex has properties: they are left out (" +
                    anomalies.LinesWithExtraValues + " lines in this block; later blocks are not counted)");
            }
        }
    }

    // What writers call vertex properties; case is ignored. All others keep the name in the file.
    internal static class PlyNames
    {
        // Rows that only count if all their names are present: "r" alone may be a radius.
        static readonly string[][] s_groups =
        {
            new[] { "x", AttributeNames.X }, new[] { "y", AttributeNames.Y }, new[] { "z", AttributeNames.Z },
            new[] { "red", AttributeNames.Red }, new[] { "green", AttributeNames.Green }, new[] { "blue", AttributeNames.Blue },
            new[]
            {
                "diffuse_red", AttributeNames.Red, "diffuse_green", AttributeNames.Green, "diffuse_blue", AttributeNames.Blue,
            },
            new[] { "r", AttributeNames.Red, "g", AttributeNames.Green, "b", AttributeNames.Blue },
            new[] { "alpha", AttributeNames.Alpha }, new[] { "diffuse_alpha", AttributeNames.Alpha },
            new[] { "r", "", "g", "", "b", "", "a", AttributeNames.Alpha },
            new[] { "nx", AttributeNames.NormalX, "ny", AttributeNames.NormalY, "nz", AttributeNames.NormalZ },
            new[]
            {
                "normal_x", AttributeNames.NormalX, "normal_y", AttributeNames.NormalY, "normal_z", AttributeNames.NormalZ,
            },
            new[] { "intensity", AttributeNames.Intensity }, new[] { "scalar_intensity", AttributeNames.Intensity },
            new[] { "reflectance", AttributeNames.Intensity },
        };

        // Null for lists. No name comes twice: of several candidates the first row of the table wins, and a name that the file
        // repeats gets a number.
        public static string[] Of(PlyElement vertex)
        {
            var properties = vertex.Properties;
            var indexOfName = new Dictionary<string, int>(StringComparer.OrdinalIgnoreCase);
            for (int i = 0; i < properties.Count; i++)
                if (!properties[i].IsList && !indexOfName.ContainsKey(properties[i].Name))
                    indexOfName.Add(properties[i].Name, i);

            var names = new string[properties.Count];
            var taken = new HashSet<string>();
            foreach (var group in s_groups)
                AssignGroup(group, indexOfName, names, taken);
            for (int i = 0; i < names.Length; i++)
            {
                if (names[i] != null || properties[i].IsList)
                    continue;
                names[i] = CommonNames.Of(properties[i].Name);
                if (names[i] != null && taken.Add(names[i]))
                    continue;
                string name = properties[i].Name;
                for (int n = 2; !taken.Add(name); n++)
                    name = properties[i].Name + "_" + n;
                names[i] = name;
            }
            return names;
        }

        static void AssignGroup(string[] group, Dictionary<string, int> indexOfName, string[] names, HashSet<string> taken)
        {
            for (int i = 0; i < group.Length; i += 2)
                if (!indexOfName.ContainsKey(group[i]) || taken.Contains(group[i + 1]))
                    return;
            for (int i = 0; i < group.Length; i += 2)
            {
                if (group[i + 1].Length == 0)
                    continue;
                names[indexOfName[group[i]]] = group[i + 1];
                taken.Add(group[i + 1]);
            }
        }
    }
}
