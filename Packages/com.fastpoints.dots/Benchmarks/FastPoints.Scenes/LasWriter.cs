using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using FastPoints.Las;
using FastPoints.Reading;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Scenes
{
    // Writes points as they come; counts and bounds go into the header at the end. The file has a temporary name until Complete:
    // if disposed before that, it is deleted, and an existing file of that name is unchanged.
    internal sealed unsafe class LasWriter : IDisposable
    {
        const int BufferBytes = 1 << 20;
        const string TemporarySuffix = ".partial";

        readonly string m_path;
        readonly string m_temporaryPath;
        readonly LasHeader m_header;
        readonly LasRecordLayout m_layout;
        readonly byte[] m_buffer;
        readonly int m_bufferPoints;
        readonly ulong[] m_byReturn = new ulong[16];
        FileStream m_stream;
        int3 m_min = new int3(int.MaxValue, int.MaxValue, int.MaxValue);
        int3 m_max = new int3(int.MinValue, int.MinValue, int.MinValue);

        LasWriter(string path, LasWriterSettings settings)
        {
            m_path = path;
            m_temporaryPath = path + TemporarySuffix;
            var format = LasPointFormat.Of(settings.PointFormat);
            var extra = new List<PointField>();
            int recordBytes = format.RecordBytes;
            foreach (var attribute in settings.ExtraBytes)
            {
                extra.Add(new PointField(attribute.Name, attribute.Type, recordBytes, attribute.Scale, attribute.Offset));
                recordBytes += attribute.Type.SizeOf();
            }
            m_layout = new LasRecordLayout(format, recordBytes, extra);
            m_header = new LasHeader
            {
                VersionMinor = settings.VersionMinor,
                PointFormat = settings.PointFormat,
                RecordBytes = recordBytes,
                HeaderBytes = LasHeader.BytesOf(settings.VersionMinor),
                Scale = settings.Scale,
                Offset = settings.Offset,
                SystemIdentifier = settings.SystemIdentifier,
                GeneratingSoftware = "FastPoints",
                GlobalEncoding = settings.Wkt != null && settings.VersionMinor >= 4 ? LasHeader.WktBit : (ushort)0,
            };
            m_bufferPoints = Math.Max(1, BufferBytes / recordBytes);
            m_buffer = new byte[m_bufferPoints * recordBytes];
        }

        public PointSchema Schema => m_layout.Schema; // A batch to append may have any selection of these.

        public int RecordBytes => m_header.RecordBytes;

        public static LasWriter Create(string path, LasWriterSettings settings)
        {
            var writer = new LasWriter(path, settings);
            var vlrs = Vlrs(settings);
            writer.m_header.VlrCount = (uint)vlrs.Count;
            long pointsOffset = writer.m_header.HeaderBytes;
            foreach (var vlr in vlrs)
                pointsOffset += vlr.Length;
            writer.m_header.PointsOffset = (uint)pointsOffset;
            try
            {
                writer.m_stream = FileChanges.OpenToWrite(writer.m_temporaryPath, FileMode.Create);
                var header = writer.m_header.ToBytes();
                writer.m_stream.Write(header, 0, header.Length);
                foreach (var vlr in vlrs)
                    writer.m_stream.Write(vlr, 0, vlr.Length);
                return writer;
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                writer.Dispose();
                throw FileFailures.WriteFailure(path, e);
            }
        }

        // Attributes that the batch lacks are zero.
        public void Append(PointBatch batch)
        {
            var copies = FieldCopyPlan.Make(m_layout.Fields, batch);
            byte* columns = (byte*)batch.Bytes.GetUnsafeReadOnlyPtr();
            for (int first = 0; first < batch.Count; first += m_bufferPoints)
            {
                int count = Math.Min(m_bufferPoints, batch.Count - first);
                Array.Clear(m_buffer, 0, count * RecordBytes);
                fixed (byte* records = m_buffer)
                fixed (FieldCopy* plan = copies)
                    PointRecords.FromColumns(columns, first, count, new FieldCopies(plan, copies.Length), records, RecordBytes);
                Write(m_buffer, count);
            }
        }

        public void AppendRecords(byte[] records, int count)
        {
            if (count < 0 || (long)count * RecordBytes > records.Length)
                throw new ArgumentOutOfRangeException(nameof(count), count, "more records than bytes");
            Write(records, count);
        }

        // Gives the file its name; not for the main thread of an editor.
        public void Complete()
        {
            m_header.SetCountsAndBounds(m_path, m_byReturn, m_min, m_max);
            try
            {
                var header = m_header.ToBytes();
                m_stream.Position = 0;
                m_stream.Write(header, 0, header.Length);
                m_stream.Flush(true);
                m_stream.Dispose();
                m_stream = null;
                FileChanges.Retry(() => FileChanges.Replace(m_temporaryPath, m_path));
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                throw FileFailures.WriteFailure(m_path, e);
            }
        }

        public void Dispose()
        {
            if (m_stream == null)
                return;
            m_stream.Dispose();
            m_stream = null;
            FileChanges.TryDelete(m_temporaryPath, () => false);
        }

        void Write(byte[] records, int count)
        {
            if (m_stream == null)
                throw new InvalidOperationException("the writer is complete");
            fixed (byte* first = records)
                Account(first, count);
            try
            {
                m_stream.Write(records, 0, count * RecordBytes);
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                throw FileFailures.WriteFailure(m_path, e);
            }
        }

        void Account(byte* record, int count)
        {
            int returnMask = m_layout.Format.IsExtended ? 15 : 7;
            for (int i = 0; i < count; i++, record += RecordBytes)
            {
                var position = new int3(((int*)record)[0], ((int*)record)[1], ((int*)record)[2]);
                m_min = math.min(m_min, position);
                m_max = math.max(m_max, position);
                m_byReturn[record[14] & returnMask]++;
            }
            m_header.Count64 += (ulong)count;
        }

        static List<byte[]> Vlrs(LasWriterSettings settings)
        {
            var vlrs = new List<byte[]>();
            if (settings.Wkt != null)
                vlrs.Add(LasVlr.ToBytes(LasVlr.ProjectionUser, LasVlr.WktRecord, "OGC WKT",
                    Encoding.UTF8.GetBytes(settings.Wkt + "\0")));
            if (settings.ExtraBytes.Length == 0)
                return vlrs;
            var entries = new byte[settings.ExtraBytes.Length * LasExtraBytes.EntryBytes];
            for (int i = 0; i < settings.ExtraBytes.Length; i++)
                LasExtraBytes.Entry(settings.ExtraBytes[i]).CopyTo(entries, i * LasExtraBytes.EntryBytes);
            vlrs.Add(LasVlr.ToBytes(LasVlr.SpecificationUser, LasVlr.ExtraBytesRecord, "Extra bytes", entries));
            return vlrs;
        }
    }

    internal sealed class LasWriterSettings
    {
        public int VersionMinor = 4; // LAS 1.0 to 1.5: 0 to 5. Point formats 4 and 5 need 1.3, those from 6 on 1.4.

        public int PointFormat = 7;

        // Position = stored * scale + offset; all finite, and the scale not 0.
        public double3 Scale = new double3(0.001, 0.001, 0.001);

        public double3 Offset;
        public string Wkt;
        public string SystemIdentifier = "OTHER";
        public PointAttribute[] ExtraBytes = Array.Empty<PointAttribute>();
    }
}
