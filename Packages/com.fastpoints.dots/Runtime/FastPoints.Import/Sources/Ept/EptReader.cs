using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Las;
using FastPoints.Laz;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Sources
{
    // Entwine Point Tiles (EPT 0.0.0 and 1.x): ept.json, pages of a hierarchy, and a file a node: plain records, zstandard or
    // LAZ. A node's file is opened for its range and closed behind it. A node with more points than a slot should hold becomes
    // several blocks; if it is compressed, each block decodes its file from the start.
    internal sealed class EptReader : NodeReader
    {
        const string DataFolder = "ept-data";
        const int MaxBlockPoints = 1 << 20;
        const int MaxBlockBytes = 32 << 20;

        readonly EptHierarchy m_hierarchy;
        readonly int m_blockPoints;
        readonly LasTemplate m_template; // The LAZ file of one node, as the template of the others; null for other data types.

        EptReader(EptMetadata metadata, LasTemplate template) : base(metadata.Info, metadata.Cube, metadata.Spacing)
        {
            Metadata = metadata;
            m_template = template;
            int pointBytes = Math.Max(Info.Schema.BytesPerPoint, template?.Las.Header.RecordBytes ?? metadata.RecordBytes);
            m_blockPoints = Math.Max(1, Math.Min(MaxBlockPoints, MaxBlockBytes / pointBytes));
            m_hierarchy = new EptHierarchy(this);
        }

        internal static EptReader Open(JsonMembers json)
        {
            var metadata = EptMetadata.Read(json);
            if (metadata.DataType != EptDataType.Laszip)
                return new EptReader(metadata, null);
            // A node's own scale and offset count even if ept.json gives others.
            var template = new LasTemplate(PathOfAnyNode(metadata));
            var las = template.Las;
            if (template.Laz == null)
                throw PointCloudException.Wanted(FailureCode.BadInput, las.Info.Path, LasHeader.At.PointFormat,
                    "a node of an EPT of data type laszip", "LAZ", "LAS");
            metadata.Info.Schema = las.Info.Schema;
            metadata.Info.Transform = las.Info.Transform;
            metadata.Info.PointFormat = las.Header.PointFormat;
            metadata.Info.GpsTime = las.Info.GpsTime;
            if (!metadata.Info.Crs.IsKnown)
                metadata.Info.Crs = las.Info.Crs;
            template.Laz.AddFacts(metadata.Info);
            return new EptReader(metadata, template);
        }

        // The root's file, or another one if it is missing.
        static string PathOfAnyNode(EptMetadata metadata)
        {
            string folder = SourcePath.Combine(metadata.Folder, DataFolder);
            string root = SourcePath.Combine(folder, "0-0-0-0.laz");
            if (SourcePath.IsRemote(root) || File.Exists(root) || !Directory.Exists(folder))
                return root;
            foreach (string path in Directory.EnumerateFiles(folder, "*.laz"))
                return path;
            return root;
        }

        internal EptMetadata Metadata { get; }

        public override bool HasCheapRanges => Metadata.DataType == EptDataType.Binary;

        internal override string NameOf(int level, int3 cell) => EptEntry.NameOf(level, cell);

        public string PathOf(int level, int3 cell) => SourcePath.Combine(SourcePath.Combine(Metadata.Folder, DataFolder),
            EptEntry.NameOf(level, cell) + (HasCheapRanges ? ".bin" : Metadata.DataType == EptDataType.Laszip ? ".laz" : ".zst"));

        private protected override int BytesPerPoint => HasCheapRanges ? Metadata.RecordBytes : 0;

        public override string FileOfBlock(int block, out long byteOffset)
        {
            byteOffset = 0;
            var node = NodeOf(block);
            return PathOf(node.Level, node.Cell);
        }

        public void Add(EptEntry entry, long points, long fileBytes) =>
            AddNode(new SourceNode { Level = entry.Level, Cell = entry.Cell }, points, m_blockPoints, 0, fileBytes,
                BytesPerPoint);

        public override long BytesOfRange(BlockRange range)
        {
            if (HasCheapRanges)
                return (long)range.Count * Metadata.RecordBytes;
            var block = Block(range.Block);
            double share = Metadata.DataType == EptDataType.Laszip ? block.NodePoints
                : block.FirstInNode + range.First + range.Count;
            return (long)(BytesOf(block) * Math.Min(1, share / block.NodePoints));
        }

        public override IEnumerator<JobStep> ReadHierarchyBelow(int4 node, int levels) =>
            m_hierarchy.Read(node, Math.Max(1, levels));

        public override bool IsKnownBelow(int4 node, int levels) => Tree.IsHierarchyRead || m_hierarchy.IsKnown(node, levels);

        public override IEnumerator<JobStep> IndexBlocks()
        {
            if (Tree.IsHierarchyRead)
                yield break;
            yield return JobStep.Of(m_hierarchy.Read(default, int.MaxValue));
            string found = "ept.json claims " + NumberText.Of(Info.PointsClaimed)
                + " points, the nodes that are there hold " + NumberText.Of(PointCount);
            if (PointCount == 0 && Info.PointsClaimed > 0)
                throw new PointCloudException(FailureCode.Truncated, Info.Path, -1, found);
            if ((ulong)PointCount != Info.PointsClaimed)
                Info.Warn(-1, found);
            Info.PointsReadable = PointCount;
            Tree.IsHierarchyRead = true;
        }

        public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator)
        {
            if (m_template != null)
                return new LasNodeRead(this, m_template, false, wanted, capacity, allocator);
            if (Metadata.DataType == EptDataType.Zstandard && Decompressors.Zstandard == null)
                throw new PointCloudException(FailureCode.Unsupported, Info.Path, -1, "its points are compressed by "
                    + "zstandard, for which .NET Standard 2.1 has nothing: set Decompressors.Zstandard to a decompressor "
                    + "(the command line takes the system's libzstd), or convert it (./fastpoints convert, or pdal "
                    + "translate to LAZ)");
            return new EptRecordRead(this, HasCheapRanges ? null : Decompressors.Zstandard, wanted, capacity, allocator);
        }
    }
}
