using System;
using FastPoints.Core;
using FastPoints.Reading;
using Unity.Collections;

namespace FastPoints.Las
{
    // Records have a fixed length, so a block is a range of records whose size suits slices of work, and any part of it costs
    // what it holds.
    internal sealed class LasReader : PointReader
    {
        // Measured beside 16,384 and 65,536: blocks in flight stay in the caches, and there are not too many of them.
        const int MaxBlockPoints = 32768;
        const int MaxBlockBytes = 4 << 20;

        readonly LasFile m_las;
        readonly int m_blockPoints;
        readonly FixedRecords m_records;

        LasReader(LasFile las)
        {
            m_las = las;
            Info = las.Info;
            m_records = new FixedRecords(new SourceHandle(Info.Path), las.Layout.Fields, las.Header.PointsOffset,
                Info.RecordBytes);
            m_blockPoints = Math.Min(MaxBlockPoints, Math.Max(1, MaxBlockBytes / Info.RecordBytes));
            long blocks = (Info.PointsReadable + m_blockPoints - 1) / m_blockPoints;
            if (blocks > int.MaxValue)
                throw PointCloudException.Wanted(FailureCode.Unsupported, Info.Path, las.Header.PointsClaimedAt, "points",
                    "at most " + (long)int.MaxValue * m_blockPoints, Info.PointsReadable);
            BlockCount = (int)blocks;
        }

        // Whatever the header says about compression.
        internal static PointReader OpenUncompressed(LasFile las, FileSource source)
        {
            las.Info.PointsReadable = LasClaims.CountReadable(las.Header, source.Length, las.Info);
            LasClaims.CheckBounds(las.Header, source, las.Info.PointsReadable, las.Info);
            return new LasReader(las);
        }

        internal override LasFile Las => m_las;

        public LasHeader Header => m_las.Header;

        public LasVlrTable Vlrs => m_las.Vlrs;

        public override int BlockCount { get; }

        public override int MaxPointsPerBlock => (int)Math.Min(m_blockPoints, Info.PointsReadable);

        public override bool HasFixedStride => true;

        public override bool HasRunReads => true;

        public override long FirstPointOfBlock(int block)
        {
            CheckBlock(block);
            return (long)block * m_blockPoints;
        }

        public override int PointsInBlock(int block)
        {
            CheckBlock(block);
            return (int)Math.Min(m_blockPoints, Info.PointsReadable - (long)block * m_blockPoints);
        }

        public override long BytesOfRange(BlockRange range) => (long)range.Count * Info.RecordBytes;

        public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator) =>
            new RecordRead(this, m_records, wanted, capacity, allocator);

        internal override RunRead CreateRunRead(PointBatch target, int maxRuns, int maxBytes, Allocator allocator) =>
            new RunRead(m_records, target, maxRuns, maxBytes, allocator);

        public override void CloseFile() => m_records.File.Close();

        void CheckBlock(int block)
        {
            if ((uint)block >= (uint)BlockCount)
                throw new ArgumentOutOfRangeException(nameof(block), block, "the source has " + BlockCount + " blocks");
        }
    }
}
