using System;
using System.Collections.Generic;
using FastPoints.Reading;

namespace FastPoints.Las
{
    // The variable length records of a file, before and after the points. Counts and lengths are claims: the walk ends with a
    // warning if they exceed the file, and points still load.
    internal sealed class LasVlrTable
    {
        // The largest real file seen has 390. This bounds the memory that a header can claim.
        public const int MaxRecords = 65536;

        // Larger payloads are listed but not read: WKT and key tables are a few kilobytes.
        public const int MaxPayloadBytes = 4 << 20;

        readonly RandomAccessFile m_source;
        readonly SourceInfo m_info;
        readonly List<LasVlr> m_records = new List<LasVlr>();

        LasVlrTable(RandomAccessFile source, SourceInfo info)
        {
            m_source = source;
            m_info = info;
        }

        public IReadOnlyList<LasVlr> Records => m_records;

        public static LasVlrTable Read(RandomAccessFile source, LasHeader header, SourceInfo info)
        {
            var table = new LasVlrTable(source, info);
            long start = Math.Max(header.HeaderBytes, LasHeader.MinBytes);
            long end = Math.Min(header.PointsOffset, source.Length);
            table.Walk(start, end, header.VlrCount, false, LasHeader.At.VlrCount);
            if (header.EvlrCount == 0)
                return table;
            if (header.EvlrOffset < header.PointsOffset || header.EvlrOffset > (ulong)source.Length)
                info.Warn(LasHeader.At.EvlrOffset, "the header claims " + NumberText.Of(header.EvlrCount) + " EVLRs from byte "
                    + NumberText.Of(header.EvlrOffset) + ", which is not behind the points: left out");
            else
                table.Walk((long)header.EvlrOffset, source.Length, header.EvlrCount, true, LasHeader.At.EvlrCount);
            return table;
        }

        // The first whose bytes can be read, or null.
        public LasVlr Find(string userId, ushort recordId)
        {
            foreach (var record in m_records)
                if (record.Is(userId, recordId))
                    return record;
            return null;
        }

        // Empty, with a warning, if it is too large.
        public ByteReader Payload(LasVlr record)
        {
            if (record.DataBytes <= MaxPayloadBytes)
                return m_source.ReadUpTo(record.DataOffset, (int)record.DataBytes);
            m_info.Warn(record.Offset, record.UserId + "/" + NumberText.Of(record.RecordId) + ": wanted at most "
                + NumberText.Of(MaxPayloadBytes) + " bytes, got " + NumberText.Of(record.DataBytes) + ": left out");
            return new ByteReader(Array.Empty<byte>(), m_source.Path, record.DataOffset);
        }

        void Walk(long at, long end, uint count, bool extended, int countAt)
        {
            string kind = extended ? "EVLR" : "VLR";
            int headerBytes = extended ? LasVlr.ExtendedHeaderBytes : LasVlr.HeaderBytes;
            for (uint i = 0; i < count; i++)
            {
                if (at + headerBytes > end || m_records.Count == MaxRecords)
                {
                    m_info.Warn(countAt, "the header claims " + NumberText.Of(count) + " " + kind + "s, there is room for "
                        + NumberText.Of(i) + (extended ? " in the file" : " before the points") + ": the others are left out");
                    return;
                }
                var bytes = m_source.Read(at, headerBytes, kind);
                // Bytes 0-1 are reserved; then user id, record id, length of the payload, description.
                ulong claimed = extended ? bytes.UInt64(20, "EVLR length") : bytes.UInt16(20, "VLR length");
                var record = new LasVlr
                {
                    UserId = bytes.Text(2, 16, "VLR user id"),
                    RecordId = bytes.UInt16(18, "VLR record id"),
                    Description = bytes.Text(headerBytes - 32, 32, "VLR description"),
                    Offset = at,
                    DataOffset = at + headerBytes,
                    IsExtended = extended,
                };
                long room = end - record.DataOffset;
                record.DataBytes = (long)Math.Min(claimed, (ulong)room);
                if (claimed > (ulong)room)
                {
                    m_info.Warn(at, kind + " " + NumberText.Of(i + 1) + " of " + NumberText.Of(count) + ": wanted "
                        + NumberText.Of(claimed) + " bytes, got " + NumberText.Of(room)
                        + (extended ? " before the end of the file" : " before the points") + ": it and the next are left out");
                    return;
                }
                m_records.Add(record);
                at = record.DataOffset + record.DataBytes;
            }
        }
    }

    internal sealed class LasVlr
    {
        public const int HeaderBytes = 54;
        public const int ExtendedHeaderBytes = 60;

        public const string CompressionUser = "laszip encoded";
        public const string ProjectionUser = "LASF_Projection";
        public const string SpecificationUser = "LASF_Spec";
        public const ushort WktRecord = 2112;
        public const ushort GeoKeyDirectoryRecord = 34735;
        public const ushort GeoDoubleParamsRecord = 34736;
        public const ushort GeoAsciiParamsRecord = 34737;
        public const ushort ExtraBytesRecord = 4;
        public const ushort WaveformRecord = 65535;

        public string UserId;
        public ushort RecordId;
        public string Description;
        public long Offset;
        public long DataOffset;
        public long DataBytes; // Present in the file; fewer than claimed if it was cut.
        public bool IsExtended; // From the end of the file, with a 64-bit length (LAS 1.4).

        public static byte[] ToBytes(string userId, ushort recordId, string description, byte[] payload)
        {
            if (payload.Length > ushort.MaxValue)
                throw new ArgumentException(description + ": wanted at most 65535 bytes, got " + payload.Length);
            var vlr = new byte[HeaderBytes + payload.Length];
            LasHeader.PutText(vlr, 2, 16, userId);
            LasHeader.Put(vlr, 18, 2, recordId);
            LasHeader.Put(vlr, 20, 2, (ulong)payload.Length);
            LasHeader.PutText(vlr, 22, 32, description);
            payload.CopyTo(vlr, HeaderBytes);
            return vlr;
        }

        public bool Is(string userId, ushort recordId) => RecordId == recordId && UserId == userId;

        public string Name => UserId + "/" + NumberText.Of(RecordId);

        // How the points of this file are compressed, or where an octree of it is: of no other file.
        public bool DescribesStorage => UserId == CompressionUser || UserId == "copc";

        public bool IsWaveform => Is(SpecificationUser, WaveformRecord);

        public bool IsExtraBytes => Is(SpecificationUser, ExtraBytesRecord);

        public bool IsCrs => UserId == ProjectionUser && (RecordId == WktRecord || RecordId == GeoKeyDirectoryRecord ||
            RecordId == GeoDoubleParamsRecord || RecordId == GeoAsciiParamsRecord);
    }
}
