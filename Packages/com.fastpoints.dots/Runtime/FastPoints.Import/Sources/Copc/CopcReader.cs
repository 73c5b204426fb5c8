using System;
using System.Collections.Generic;
using FastPoints.Las;
using FastPoints.Laz;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Sources
{
    // COPC 1.0: a LAZ file of layered chunks, each of which is a node of an octree and so a block. The hierarchy is a claim like
    // any other: chunks that are only in the LAZ chunk table are read too, behind the tree's blocks, and a file without a
    // readable hierarchy is read as the LAZ file that it is.
    internal sealed class CopcReader : LazChunkReader, IOctreeSource
    {
        const int DefaultPointsAcross = 128;

        readonly CopcHierarchy m_hierarchy;

        CopcReader(LazBlocks blocks, CopcInfo copc) : base(blocks)
        {
            Info.Format = "COPC";
            Copc = copc;
            double spacing = copc.Spacing;
            if (!(spacing > 0) || double.IsInfinity(spacing))
            {
                spacing = 2 * copc.HalfSize / DefaultPointsAcross;
                Info.Warn(copc.FileOffset, "the octree's spacing is " + NumberText.Of(copc.Spacing)
                    + ": taken as the edge of its cube over " + DefaultPointsAcross);
            }
            Tree = new SourceTree(copc.Cube, spacing, Allocator.Persistent);
            m_hierarchy = new CopcHierarchy(blocks, copc, Tree);
        }

        // Null if the file is not COPC, or can only be read as LAZ, with a warning. longChunkPoints: of a node that is one block.
        public static PointReader TryOpen(LasFile las, RandomAccessFile source, int longChunkPoints = MaxBlockPoints)
        {
            var copc = CopcInfo.Find(las);
            if (copc == null)
                return null;
            string problem = copc.Problem(source.Length);
            if (problem != null)
            {
                las.Info.Warn(copc.FileOffset, "COPC: " + problem + ": read as LAZ, without the octree");
                return null;
            }
            var format = LazFormat.Read(las);
            if (!format.IsLayered)
            {
                las.Info.Warn(copc.FileOffset, "COPC: wanted layered chunks, got " + format.Compressor
                    + ": read without the octree");
                return null;
            }
            copc.AddFacts(las.Info);
            format.AddFacts(las.Info);
            return new CopcReader(new LazBlocks(las, format, source, longChunkPoints), copc);
        }

        public CopcInfo Copc { get; }

        internal override SourceTree Tree { get; }

        public override bool BlocksAreKnown => Tree.IsHierarchyRead;

        public IEnumerator<JobStep> ReadHierarchyBelow(int4 node, int levels) => m_hierarchy.Read(node, Math.Max(1, levels));

        public bool IsKnownBelow(int4 node, int levels) => Tree.IsHierarchyRead || m_hierarchy.IsKnown(node, levels);

        public override IEnumerator<JobStep> IndexBlocks()
        {
            if (Tree.IsHierarchyRead)
                yield break;
            yield return JobStep.Of(m_hierarchy.Read(default, int.MaxValue));
            m_hierarchy.WarnUnreported();
            yield return JobStep.Of(PoolTask.Run(Info.Path, CompleteBlocks, checkedAll => Tree.IsHierarchyRead = checkedAll));
        }

        bool CompleteBlocks()
        {
            if ((ulong)PointCount != Info.PointsClaimed)
                Reconcile();
            Info.PointsReadable = PointCount;
            Blocks.CheckBounds();
            Blocks.Source.Dispose();
            return true;
        }

        void Reconcile()
        {
            long ofNodes = PointCount;
            Info.Warn(LasHeader.At.Count64, "the header claims " + Info.PointsClaimed + " points, the octree's nodes "
                + NumberText.Of(ofNodes));
            var chunks = Blocks.Chunks;
            var known = new HashSet<long>();
            for (int c = 0; c < chunks.Count; c++)
                known.Add(chunks[c].Offset);
            var table = LazChunkTable.Read(Blocks.Source, Format, Info, Header.PointsOffset);
            int found = 0;
            for (int c = 0; c < table.Chunks.Count; c++)
            {
                var chunk = table.Chunks[c];
                if (known.Contains(chunk.Offset) || chunk.Bytes > LazBlocks.MaxLayeredChunkBytes)
                    continue;
                chunks.Add(chunk);
                Blocks.AddChunk(chunks.Count - 1);
                found++;
            }
            if (found > 0)
                Info.Warn(Header.PointsOffset, NumberText.Of(found) + " chunks with " + NumberText.Of(PointCount - ofNodes)
                    + " points are in the LAZ chunk table and in no node: they are read behind the nodes");
            if (PointCount == 0 && Info.PointsClaimed > 0)
                throw new PointCloudException(FailureCode.Truncated, Info.Path, Header.PointsOffset, "the header claims "
                    + Info.PointsClaimed + " points, the file holds none");
        }

        public override void DisposeUnread() => Tree.Dispose();
    }

    // The copc info VLR (COPC 1.0), the first of a file, so that its data starts at byte 429; other places are tolerated.
    internal sealed class CopcInfo
    {
        public const string UserId = "copc";
        public const ushort InfoRecord = 1;
        public const ushort HierarchyRecord = 1000;
        public const int Bytes = 160;

        const int FieldBytes = 72;
        public double3 Center; // In CRS units, like all lengths here.

        public double HalfSize;
        public double Spacing;
        public ulong RootPageOffset;
        public ulong RootPageBytes;
        public double MinGpsTime;
        public double MaxGpsTime;
        public long FileOffset;

        public BoundsGeo Cube => new BoundsGeo(Center - HalfSize, Center + HalfSize);

        public static CopcInfo Find(LasFile las)
        {
            var record = las.Vlrs.Find(UserId, InfoRecord);
            if (record == null)
                return null;
            var bytes = las.Vlrs.Payload(record);
            var info = new CopcInfo { FileOffset = record.DataOffset };
            if (!bytes.Has(0, FieldBytes))
                return info;
            for (int axis = 0; axis < 3; axis++)
                info.Center[axis] = bytes.Float64(8 * axis, "center");
            info.HalfSize = bytes.Float64(24, "halfsize");
            info.Spacing = bytes.Float64(32, "spacing");
            info.RootPageOffset = bytes.UInt64(40, "root page offset");
            info.RootPageBytes = bytes.UInt64(48, "root page size");
            info.MinGpsTime = bytes.Float64(56, "smallest GPS time");
            info.MaxGpsTime = bytes.Float64(64, "largest GPS time");
            return info;
        }

        public byte[] ToBytes()
        {
            var bytes = new byte[Bytes];
            for (int axis = 0; axis < 3; axis++)
                LasHeader.PutFloat(bytes, 8 * axis, Center[axis]);
            LasHeader.PutFloat(bytes, 24, HalfSize);
            LasHeader.PutFloat(bytes, 32, Spacing);
            LasHeader.Put(bytes, 40, 8, RootPageOffset);
            LasHeader.Put(bytes, 48, 8, RootPageBytes);
            LasHeader.PutFloat(bytes, 56, MinGpsTime);
            LasHeader.PutFloat(bytes, 64, MaxGpsTime);
            return bytes;
        }

        public string Problem(long fileBytes)
        {
            if (!Cube.IsFinite || !(HalfSize > 0))
                return "the octree's cube is none (half of its edge is " + NumberText.Of(HalfSize) + ")";
            if (RootPageOffset > (ulong)fileBytes || RootPageBytes > (ulong)fileBytes - RootPageOffset)
                return "the root page of the hierarchy would lie at byte " + NumberText.Of(RootPageOffset) + " with "
                    + NumberText.Of(RootPageBytes) + " bytes, the file has " + NumberText.Of((ulong)fileBytes);
            return RootPageBytes < CopcEntry.Bytes
                ? "the root page of the hierarchy has " + NumberText.Of(RootPageBytes) + " bytes, wanted at least "
                    + CopcEntry.Bytes
                : null;
        }

        public void AddFacts(SourceInfo info)
        {
            info.AddFact("COPC version", "1.0");
            info.AddFact("COPC center", NumberText.Of(Center.x) + " " + NumberText.Of(Center.y) + " " + NumberText.Of(Center.z));
            info.AddFact("COPC half size", NumberText.Of(HalfSize));
            info.AddFact("COPC spacing", NumberText.Of(Spacing));
            info.AddFact("COPC root page", NumberText.Of(RootPageBytes) + " bytes at byte " + NumberText.Of(RootPageOffset));
            info.AddFact("COPC GPS time", NumberText.Of(MinGpsTime) + " to " + NumberText.Of(MaxGpsTime));
        }
    }
}
