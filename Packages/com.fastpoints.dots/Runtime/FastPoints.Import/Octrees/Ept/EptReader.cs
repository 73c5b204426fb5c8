using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Core;
using FastPoints.Las;
using FastPoints.Laz;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Octrees
{
    // Entwine Point Tiles (EPT 0.0.0 and 1.x): ept.json, pages of a hierarchy, and a file a node: plain records, zstandard or
    // LAZ. A node's file is opened for its range and closed behind it. A node with more points than a slot should hold becomes
    // several blocks; if it is compressed, each block decodes its file from the start.
    internal sealed class EptReader : PointReader
    {
        readonly EptIndex m_index;
        readonly EptBlocks m_blocks;
        readonly EptHierarchy m_hierarchy;

        // A LAZ file like those of the nodes, if they are LAZ; otherwise null.
        readonly LasFile m_las;
        readonly LazFormat m_laz;

        EptReader(EptIndex index, LasFile las, LazFormat laz)
        {
            m_index = index;
            Info = index.Info;
            m_las = las;
            m_laz = laz;
            m_blocks = new EptBlocks(index, Math.Max(Info.Schema.BytesPerPoint, las?.Header.RecordBytes ?? index.RecordBytes));
            m_hierarchy = new EptHierarchy(index, m_blocks);
        }

        internal static EptReader Open(JsonMembers json)
        {
            var index = EptIndex.Read(json);
            if (index.DataType != EptDataType.Laszip)
                return new EptReader(index, null, null);
            // Nodes have a scale and offset of their own, which count even if ept.json gives others.
            using var source = FileSource.Open(AnyNode(index));
            var las = LasFile.Read(source);
            if (!las.Header.IsCompressed)
                throw PointCloudException.Wanted(FailureCode.BadInput, source.Path, LasHeader.At.PointFormat,
                    "a node of an EPT of data type laszip", "LAZ", "LAS");
            var format = LazFormat.Read(las);
            if (format.Compressor == LazCompressor.None)
                throw PointCloudException.Wanted(FailureCode.Unsupported, source.Path, LasHeader.At.PointFormat,
                    "LASzip compressor", "1 to 3", 0);
            index.Info.Schema = las.Info.Schema;
            index.Info.Transform = las.Info.Transform;
            index.Info.PointFormat = las.Header.PointFormat;
            if (!index.Info.Crs.IsKnown)
                index.Info.Crs = las.Info.Crs;
            format.AddFacts(index.Info);
            return new EptReader(index, las, format);
        }

        static string AnyNode(EptIndex index)
        {
            string folder = Path.Combine(index.Folder, EptBlocks.DataFolder);
            string root = Path.Combine(folder, "0-0-0-0.laz");
            if (File.Exists(root) || !Directory.Exists(folder))
                return root;
            foreach (string path in Directory.EnumerateFiles(folder, "*.laz"))
                return path;
            return root;
        }

        internal override SourceTree Tree => m_blocks.Tree;

        public override bool BlocksAreKnown => m_blocks.Tree.IsWhole;

        public override int BlockCount => m_blocks.Count;

        public override int MaxPointsPerBlock => m_blocks.MaxPoints;

        public override bool HasFixedStride => m_index.DataType == EptDataType.Binary;

        public override long FirstPointOfBlock(int block) => m_blocks[block].FirstPoint;

        public override int PointsInBlock(int block) => m_blocks[block].Points;

        public override string FileOfBlock(int block, out long byteOffset)
        {
            byteOffset = 0;
            return m_blocks.PathOf(m_blocks[block]);
        }

        public override long BytesOfRange(BlockRange range)
        {
            var block = m_blocks[range.Block];
            double share = HasFixedStride ? range.Count : m_index.DataType == EptDataType.Laszip ? block.NodePoints
                : block.FirstInNode + range.First + range.Count;
            return (long)(block.FileBytes * Math.Min(1, share / block.NodePoints));
        }

        public override IEnumerator<JobStep> FindBelow(int4 node, int levels) => m_hierarchy.Read(node, Math.Max(1, levels));

        public override bool IsKnownBelow(int4 node, int levels) => m_blocks.Tree.IsWhole || m_hierarchy.IsKnown(node, levels);

        public override IEnumerator<JobStep> FindBlocks()
        {
            if (m_blocks.Tree.IsWhole)
                yield break;
            yield return JobStep.Of(m_hierarchy.Read(default, int.MaxValue));
            string found = "ept.json claims " + NumberText.Of(Info.PointsClaimed)
                + " points, the nodes that are there hold " + NumberText.Of(m_blocks.PointCount);
            if (m_blocks.PointCount == 0 && Info.PointsClaimed > 0)
                throw new PointCloudException(FailureCode.Truncated, Info.Path, -1, found);
            if ((ulong)m_blocks.PointCount != Info.PointsClaimed)
                Info.Warn(-1, found);
            Info.PointsReadable = m_blocks.PointCount;
            m_blocks.Tree.IsWhole = true;
        }

        public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator)
        {
            switch (m_index.DataType)
            {
                case EptDataType.Laszip:
                    return new EptLazRead(this, m_blocks, (m_las, m_laz), wanted, capacity, allocator);
                case EptDataType.Zstandard:
                    if (Decompressors.Zstandard == null)
                        throw new PointCloudException(FailureCode.Unsupported, Info.Path, -1, "its points are compressed by "
                            + "zstandard, for which .NET Standard 2.1 has nothing: set Decompressors.Zstandard to a decompressor "
                            + "(the command line takes the system's libzstd), or convert it (./fastpoints convert, or pdal "
                            + "translate to LAZ)");
                    return new EptZstandardRead(this, m_blocks, m_index, wanted, capacity, allocator);
                default:
                    return new EptRecordRead(this, m_blocks, m_index, wanted, capacity, allocator);
            }
        }

        public override void DisposeUnread() => m_blocks.Tree.Dispose();
    }
}
