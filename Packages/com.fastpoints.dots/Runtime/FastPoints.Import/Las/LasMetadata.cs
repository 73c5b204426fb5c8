using System;
using System.Collections.Generic;
using FastPoints.Reading;

namespace FastPoints.Las
{
    /// <summary>What several LAS files have in common besides points: header fields, and records byte by byte. A cloud
    /// keeps it as a LAS file without points.</summary>
    internal sealed class LasMetadata
    {
        public const long MaxBytes = 16 << 20; // More bytes of records are not kept.

        const int MaxNames = 8;

        readonly List<Record> m_records = new List<Record>();
        readonly LasRecordLayout m_layout;
        readonly List<string> m_differing = new List<string>();

        LasMetadata(LasFile las)
        {
            Header = las.Header;
            Crs = las.Info.Crs;
            GpsTime = las.Info.GpsTime;
            m_layout = las.Layout;
            UndescribedBytes = las.Header.RecordBytes - las.Layout.DescribedBytes;
        }

        public LasHeader Header { get; }

        public CoordinateSystem Crs { get; private set; } // Unknown if the files' records of it differ.

        public GpsTime GpsTime { get; }

        public int UndescribedBytes { get; private set; } // Bytes at the end of a point that no record describes.

        public IReadOnlyList<Record> All => m_records; // In the order of the first file.

        /// <summary>Any thread: opens each file.</summary>
        /// <returns>Null if none is a LAS file, or not all are.</returns>
        public static LasMetadata CommonTo(IReadOnlyList<string> paths, List<Loss> losses)
        {
            LasMetadata all = null;
            foreach (string path in paths)
            {
                var one = TryRead(path, losses);
                if (one == null)
                {
                    if (all != null)
                        losses.Add(new Loss("header and records of LAS files", path, "this one has none"));
                    return null;
                }
                if (all == null)
                    all = one;
                else
                    all.Intersect(one);
            }
            if (all?.m_differing.Count > 0)
                losses.Add(new Loss(Names(all.m_differing), paths[0], "other sources have others"));
            return all;
        }

        /// <summary>The records kept with a cloud; null if there are none.</summary>
        public static LasMetadata Read(string path)
        {
            if (RandomAccessFile.LengthOf(path) == RandomAccessFile.NoSuchFile)
                return null;
            using var source = RandomAccessFile.Open(path);
            return Of(source, new List<Loss>());
        }

        public IEnumerable<(byte[] Entry, List<PointField> Fields)> ExtraBytes
        {
            get
            {
                int index = m_records.FindIndex(r => r.Vlr.IsExtraBytes);
                return LasExtraBytes.Split(index >= 0 ? m_records[index].Payload : Array.Empty<byte>(), m_layout);
            }
        }

        /// <summary>A LAS file without points.</summary>
        public byte[] ToBytes()
        {
            var header = CopyWithoutPoints(Header);
            header.GeneratingSoftware = Header.GeneratingSoftware;
            header.HeaderBytes = LasHeader.BytesOf(header.VersionMinor);
            header.RecordBytes = Header.RecordBytes;
            header.Scale = Header.Scale;
            header.Offset = Header.Offset;
            long end = header.HeaderBytes;
            foreach (bool isExtended in new[] { false, true })
            {
                if (isExtended)
                    header.PointsOffset = (uint)end;
                foreach (var record in m_records)
                    end += record.IsExtended == isExtended ? record.Bytes.Length : 0;
            }
            header.VlrCount = (uint)m_records.FindAll(r => !r.IsExtended).Count;
            header.EvlrCount = (uint)m_records.Count - header.VlrCount;
            header.EvlrOffset = header.EvlrCount > 0 ? header.PointsOffset : 0;
            var bytes = new byte[end];
            header.ToBytes().CopyTo(bytes, 0);
            long at = header.HeaderBytes;
            foreach (bool isExtended in new[] { false, true })
                foreach (var record in m_records.FindAll(r => r.IsExtended == isExtended))
                {
                    record.Bytes.CopyTo(bytes, at);
                    at += record.Bytes.Length;
                }
            return bytes;
        }

        /// <summary>All fields except those that depend on points.</summary>
        public static LasHeader CopyWithoutPoints(LasHeader from) => new LasHeader
        {
            FileSourceId = from.FileSourceId,
            GlobalEncoding = from.GlobalEncoding,
            Guid = from.Guid,
            VersionMinor = from.VersionMinor,
            SystemIdentifier = from.SystemIdentifier,
            CreationDay = from.CreationDay,
            CreationYear = from.CreationYear,
            PointFormat = from.PointFormat,
            MinGpsTime = from.MinGpsTime,
            MaxGpsTime = from.MaxGpsTime,
            TimeOffset = from.TimeOffset,
        };

        static LasMetadata TryRead(string path, List<Loss> losses)
        {
            if (RandomAccessFile.LengthOf(path) == RandomAccessFile.NoSuchFile)
                return null;
            using var source = RandomAccessFile.Open(path);
            bool isLas = source.Length >= LasHeader.MinBytes &&
                source.Read(0, 4, "signature").Text(0, 4, "signature") == LasHeader.Magic;
            return isLas ? Of(source, losses) : null;
        }

        static LasMetadata Of(RandomAccessFile source, List<Loss> losses)
        {
            var las = LasFile.Read(source);
            var kept = new LasMetadata(las);
            long bytes = 0;
            var tooLong = new List<string>();
            foreach (var vlr in las.Vlrs.Records)
            {
                long length = vlr.DataOffset + vlr.DataBytes - vlr.Offset;
                if (vlr.DescribesStorage || vlr.IsWaveform)
                    continue;
                if (bytes + length > MaxBytes)
                {
                    tooLong.Add(vlr.Name);
                    continue;
                }
                bytes += length;
                kept.m_records.Add(new Record(vlr, source.Read(vlr.Offset, (int)length, "VLR").Bytes));
            }
            if (tooLong.Count > 0)
                losses.Add(new Loss(Names(tooLong), source.Path, "records of more than 16 MiB are not kept"));
            if (las.Header.HasWaveforms)
                losses.Add(new Loss("waveform packets", source.Path, "a cloud keeps where they were, and none of them"));
            return kept;
        }

        void Intersect(LasMetadata other)
        {
            LasHeader a = Header, b = other.Header;
            if (NoteUnlessSame("file source id", a.FileSourceId == b.FileSourceId))
                a.FileSourceId = 0;
            if (NoteUnlessSame("project id", a.Guid.AsSpan().SequenceEqual(b.Guid)))
                a.Guid = new byte[16];
            if (NoteUnlessSame("system identifier", a.SystemIdentifier == b.SystemIdentifier))
                a.SystemIdentifier = "";
            if (NoteUnlessSame("creation date", a.CreationDay == b.CreationDay && a.CreationYear == b.CreationYear))
                (a.CreationDay, a.CreationYear) = (0, 0);
            if (NoteUnlessSame("global encoding", a.GlobalEncoding == b.GlobalEncoding))
                a.GlobalEncoding &= b.GlobalEncoding;
            if (a.GeneratingSoftware != b.GeneratingSoftware)
                a.GeneratingSoftware = "";
            a.VersionMinor = Math.Max(a.VersionMinor, b.VersionMinor);
            (a.MinGpsTime, a.MaxGpsTime) = (Math.Min(a.MinGpsTime, b.MinGpsTime), Math.Max(a.MaxGpsTime, b.MaxGpsTime));
            UndescribedBytes = Math.Min(UndescribedBytes, other.UndescribedBytes);
            foreach (var record in other.m_records)
                NoteIfDiffers(record, this);
            m_records.RemoveAll(record => NoteIfDiffers(record, other));
        }

        bool NoteIfDiffers(Record record, LasMetadata other)
        {
            if (!NoteUnlessSame(record.Vlr.Name, other.m_records.Exists(record.Equals)))
                return false;
            if (record.Vlr.IsCrs)
                Crs = new CoordinateSystem();
            return true;
        }

        bool NoteUnlessSame(string name, bool isSame)
        {
            if (!isSame && !m_differing.Contains(name))
                m_differing.Add(name);
            return !isSame;
        }

        static string Names(List<string> names) => string.Join(", ", names.GetRange(0, Math.Min(MaxNames, names.Count))) +
            (names.Count > MaxNames ? " and " + NumberText.Of(names.Count - MaxNames) + " more" : "");

        /// <summary>With its header.</summary>
        public readonly struct Record : IEquatable<Record>
        {
            public readonly LasVlr Vlr;
            public readonly byte[] Bytes;

            public Record(LasVlr vlr, byte[] bytes) => (Vlr, Bytes) = (vlr, bytes);

            public bool IsExtended => Vlr.IsExtended;

            public byte[] Payload => Bytes.AsSpan((int)(Vlr.DataOffset - Vlr.Offset)).ToArray();

            public bool Equals(Record other) => Bytes.AsSpan().SequenceEqual(other.Bytes);
        }
    }
}
