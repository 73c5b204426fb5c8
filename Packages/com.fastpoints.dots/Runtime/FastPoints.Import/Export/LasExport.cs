using System;
using System.Collections.Generic;
using System.Text;
using FastPoints.Las;
using FastPoints.Reading;
using Unity.Mathematics;

namespace FastPoints.Export
{
    /// <summary>LAS: of a LAS source, or a cloud of such, the same point format, grid, header and records; of any other LAS 1.4
    /// in the simplest point format that has the standard attributes, everything else as extra bytes.</summary>
    internal class LasExport : ExportFormat
    {
        const int BufferBytes = 1 << 20;

        /// <summary>Coordinates without a grid get this step, or a finer one; degrees <see cref="DefaultDegrees"/>.</summary>
        const double DefaultStep = 0.001, DefaultDegrees = 1e-7;
        const long MaxVlrBytes = 64 << 20; // More bytes of records before the points than files have.
        const int StandardOffsetMegaseconds = 1000; // Adjusted standard GPS time is this much less than GPS time.

        const double MaxSteps = uint.MaxValue - 1.0;

        readonly string m_path;
        readonly LasMetadata m_records; // Null for a LAS file, which has its own records.
        readonly List<byte[]> m_vlrs = new List<byte[]>();
        byte[] m_extraBytes; // What describes the extra bytes, until it is among the records; null without any.
        readonly List<byte[]> m_tailBytes = new List<byte[]>();
        readonly List<(long, long)> m_tail = new List<(long, long)>();
        readonly bool m_isInDegrees;
        long m_waveformInTail = -1; // Where the waveforms begin in the tail; -1 without.
        uint m_evlrs;

        /// <param name="reader">Any thread: its file is opened besides.</param>
        /// <param name="chosen">The attributes to keep beside the position; null for all.</param>
        /// <param name="maxPoints">The most points that can come.</param>
        public LasExport(PointReader reader, string[] chosen, long maxPoints)
        {
            var info = reader.Info;
            m_path = info.Path;
            m_isInDegrees = double.IsNaN(info.Crs.MetresPerUnit);
            SetAxes(AttributeType.Int32);
            var las = (reader as ILasSource)?.Las;
            m_records = las == null ? LasRecordsOf(reader) : null;
            var from = las?.Header ?? m_records?.Header;
            Header = from != null ? LasMetadata.CopyWithoutPoints(from) : new LasHeader { VersionMinor = 4 };
            Header.GeneratingSoftware = "FastPoints";
            if (las == null)
                ChooseFormat(info.Schema, chosen);
            if (maxPoints > uint.MaxValue && Header.VersionMinor < 4)
                Header.VersionMinor = 4;
            Header.HeaderBytes = LasHeader.BytesOf(Header.VersionMinor);
            var format = LasPointFormat.Of(Header.PointFormat);
            ReturnMask = format.IsExtended ? 15 : 7;
            RecordBytes = format.RecordBytes;
            if (las != null && chosen == null)
                UseRecordsOf(las);
            else
                MapColumns(info, format, chosen, las != null);
            if (RecordBytes > ushort.MaxValue)
                throw new PointCloudException(FailureCode.Unsupported, info.Path, -1,
                    "a LAS record has at most 65,535 bytes, these attributes take " + NumberText.Of(RecordBytes));
            Header.RecordBytes = RecordBytes;
            if (las != null)
            {
                CopyRecords(las, chosen == null);
                if (m_extraBytes != null)
                    m_vlrs.Add(m_extraBytes);
                if (info.IsCrsOverridden)
                    AddNewCrs(info.Crs);
                else if (info.IsUnitOverridden)
                    Losses.Add(new Loss("the unit, " + info.Crs.Units.Describe(BoundsGeo.Empty), m_path,
                        "LAS has a place for it in a coordinate system alone, and the source's own is kept"));
            }
            else
            {
                AddRecords(info.Crs, chosen);
                AddTime(info);
            }
            SetPosition(info);
            BufferPoints = Math.Max(1, BufferBytes / RecordBytes);
        }

        public override IReadOnlyList<(long Offset, long Bytes)> Tail => m_tail;

        public override IReadOnlyList<byte[]> TailBytes => m_tailBytes;

        public override bool NeedsBounds => Position.Kind != PositionKind.Copied;

        protected LasHeader Header { get; }

        protected int ExtraBytes => RecordBytes - LasPointFormat.Of(Header.PointFormat).RecordBytes;

        protected void AddVlr(byte[] vlr, bool isFirst = false) => m_vlrs.Insert(isFirst ? 0 : m_vlrs.Count, vlr);

        public override byte[] MakeHeader(string path, in ExportState written, long chunksEnd, long pointsEnd)
        {
            var byReturn = new ulong[16];
            unsafe
            {
                for (int i = 0; i < byReturn.Length; i++)
                    byReturn[i] = written.ByReturn[i];
            }
            Header.Count64 = (ulong)written.Written;
            Header.SetCountsAndBounds(path, byReturn, written.Min, written.Max);
            Header.VlrCount = (uint)m_vlrs.Count;
            Header.EvlrCount = m_evlrs;
            Header.EvlrOffset = m_evlrs > 0 ? (ulong)pointsEnd : 0;
            Header.WaveformOffset = m_waveformInTail >= 0 ? (ulong)(pointsEnd + m_waveformInTail) : 0;
            long bytes = Header.HeaderBytes;
            foreach (var vlr in m_vlrs)
                bytes += vlr.Length;
            Header.PointsOffset = (uint)bytes;
            var head = new byte[bytes];
            Header.ToBytes().CopyTo(head, 0);
            int at = Header.HeaderBytes;
            foreach (var vlr in m_vlrs)
            {
                vlr.CopyTo(head, at);
                at += vlr.Length;
            }
            return head;
        }

        /// <summary>The grid: the source's own if its numbers fit, moved if only their differences do; of floats, or of too wide
        /// numbers, decimal steps.</summary>
        public override void SetBounds(in ExportState measured)
        {
            var from = Position.From;
            Position.To = from;
            Position.Divisor = 1;
            if (Position.Kind == PositionKind.Rounded)
            {
                SetDecimalGrid(new BoundsGeo(measured.MinGeo, measured.MaxGeo));
            }
            else if (measured.MinStored.X <= measured.MaxStored.X)
            {
                var size = measured.MaxStored - measured.MinStored;
                double widest = math.cmax(new double3(size.X, size.Y, size.Z));
                const long low = int.MinValue, high = int.MaxValue;
                bool fits = Grid3.Min(measured.MinStored, new Grid3(low, low, low)) == new Grid3(low, low, low) &&
                    Grid3.Max(measured.MaxStored, new Grid3(high, high, high)) == new Grid3(high, high, high);
                while (!fits && widest / Position.Divisor > MaxSteps)
                    Position.Divisor *= 10;
                Position.Base = new Grid3(BaseOf(measured.MinStored.X, measured.MaxStored.X),
                    BaseOf(measured.MinStored.Y, measured.MaxStored.Y), BaseOf(measured.MinStored.Z, measured.MaxStored.Z));
                Position.To.Scale = from.Scale * Position.Divisor;
                Position.To.Offset += from.Scale * new double3(Position.Base.X, Position.Base.Y, Position.Base.Z);
            }
            Header.Scale = Position.To.Scale;
            Header.Offset = Position.To.Offset;
        }

        /// <summary>The number that becomes 0: a round one near the middle, unless all fit as they are.</summary>
        long BaseOf(long min, long max)
        {
            if (Position.Divisor == 1 && min >= int.MinValue && max <= int.MaxValue)
                return 0;
            long middle = min + (max - min) / 2, round = (long)(1e6 * Position.Divisor), rounded = middle / round * round;
            return (max - min) / Position.Divisor < MaxSteps - 4e6 ? rounded : middle;
        }

        void SetDecimalGrid(BoundsGeo box)
        {
            if (box.IsEmpty)
                box = new BoundsGeo(default, default);
            double extent = Math.Min(double.MaxValue, math.cmax(box.Size));
            double farthest = math.cmax(math.max(math.abs(box.Min), math.abs(box.Max)));
            double step = m_isInDegrees ? DefaultDegrees : DefaultStep;
            if (extent > 0)
                step = Math.Min(step, Math.Pow(10, Math.Floor(Math.Log10(extent)) - 6));
            // Finer than the coordinates themselves is of no use.
            if (farthest > 0)
                step = Math.Max(step, Math.Pow(10, Math.Ceiling(Math.Log10(farthest)) - 16));
            while (extent / step > MaxSteps - 4e6)
                step *= 10;
            Position.To.Scale = new double3(step, step, step);
            for (int axis = 0; axis < 3; axis++)
            {
                bool fits = Math.Max(Math.Abs(box.Min[axis]), Math.Abs(box.Max[axis])) / step < int.MaxValue;
                double round = 1e6 * step;
                Position.To.Offset[axis] = fits ? 0 : Math.Round(box.Center[axis] / round) * round;
            }
        }

        void SetPosition(SourceInfo info)
        {
            var kind = PositionKind.Copied;
            foreach (var axis in Axes)
            {
                var type = info.Schema[info.Schema.IndexOf(axis.Name)].Type;
                if (type != AttributeType.Int32)
                    kind = type == AttributeType.Int64 && kind != PositionKind.Rounded ? PositionKind.Narrowed
                        : PositionKind.Rounded;
            }
            Position = new PositionConversion { Kind = kind, From = info.Transform, To = info.Transform, Divisor = 1 };
            Header.Scale = info.Transform.Scale;
            Header.Offset = info.Transform.Offset;
        }

        /// <summary>That of the files that the source was made from, or the simplest one where these have other attributes; and a
        /// version that knows it.</summary>
        protected virtual void ChooseFormat(PointSchema schema, string[] chosen)
        {
            int simplest = SimplestFormatOf(schema, chosen);
            if (m_records == null || !HasFieldsFor(schema, chosen, simplest))
                Header.PointFormat = simplest;
            int first = Header.PointFormat >= LasPointFormat.FirstExtended ? 4 : Header.PointFormat >= 4 ? 3 : 0;
            Header.VersionMinor = Math.Max(Header.VersionMinor, first);
            // Wave packets are not kept.
            Header.GlobalEncoding &= unchecked((ushort)~LasHeader.WaveformBits);
        }

        bool HasFieldsFor(PointSchema schema, string[] chosen, int simplest)
        {
            var fields = LasPointFormat.Of(Header.PointFormat).Fields;
            foreach (var field in fields)
            {
                int index = IsAxis(field.Name) ? -1 : schema.IndexOf(field.Name);
                bool isThere = index >= 0 && IsChosen(field.Name, chosen) && schema[index].Type == field.Type;
                if (!isThere && !IsAxis(field.Name))
                    return false;
            }
            foreach (var field in LasPointFormat.Of(simplest).Fields)
            {
                bool isKept = false;
                foreach (var kept in fields)
                    isKept |= kept.Name == field.Name;
                if (!isKept && schema.Has(field.Name) && IsChosen(field.Name, chosen))
                    return false;
            }
            return true;
        }

        /// <summary>The simplest format that has what is wanted. Only formats 0 to 5 have scan angles of whole degrees.</summary>
        static int SimplestFormatOf(PointSchema schema, string[] chosen)
        {
            bool Has(string name, params AttributeType[] types)
            {
                int index = schema.IndexOf(name);
                return index >= 0 && IsChosen(name, chosen) && Array.IndexOf(types, schema[index].Type) >= 0;
            }
            bool HasColor(string name) => Has(name, AttributeType.UInt8, AttributeType.UInt16);
            bool color = HasColor(AttributeNames.Red) && HasColor(AttributeNames.Green) && HasColor(AttributeNames.Blue);
            bool wave = Has(AttributeNames.WavePacketDescriptorIndex, AttributeType.UInt8);
            bool infrared = HasColor(AttributeNames.NearInfrared);
            if (!Has(AttributeNames.ScanAngle, AttributeType.Int8))
                return wave ? (color || infrared ? 10 : 9) : color ? (infrared ? 8 : 7) : 6;
            bool time = Has(AttributeNames.GpsTime, AttributeType.Float64, AttributeType.Float32);
            return wave ? (color ? 5 : 4) : (time ? 1 : 0) + (color ? 2 : 0);
        }

        /// <summary>Records with every byte of the source's.</summary>
        void UseRecordsOf(LasFile las)
        {
            RecordBytes = las.Layout.RecordBytes;
            foreach (var field in las.Layout.Fields)
                if (!IsAxis(field.Name))
                    Columns.Add(new ExportColumn { From = field.Name, To = field });
        }

        void MapColumns(SourceInfo info, LasPointFormat format, string[] chosen, bool isLas)
        {
            var standard = new PointFields();
            foreach (var field in format.Fields)
                standard.Add(field);
            var extra = new List<byte>();
            MapDescribed(info.Schema, chosen, extra);
            foreach (var attribute in info.Schema)
            {
                if (IsAxis(attribute.Name) || !IsChosen(attribute.Name, chosen) || Columns.Exists(c => c.From == attribute.Name))
                    continue;
                var column = new ExportColumn { From = attribute.Name };
                if (standard.TryFind(attribute.Name, out column.To) && Fits(attribute, column))
                {
                    if (column.To.IsBits && !isLas)
                        column.Max = (1 << column.To.BitWidth) - 1;
                    Columns.Add(column);
                    continue;
                }
                if (column.To.Name != null)
                    Losses.Add(new Loss("the field for " + attribute.Name, m_path, "it is " + attribute.Type +
                        " here, which that cannot hold: it is written as extra bytes, and the field is 0"));
                column.To = new PointField(attribute.Name, attribute.Type, RecordBytes);
                RecordBytes += attribute.Type.SizeOf();
                if (!IsUndescribed(attribute))
                    extra.AddRange(LasExtraBytes.Entry(attribute));
                Columns.Add(column);
            }
            if (extra.Count > ushort.MaxValue)
                throw PointCloudException.Wanted(FailureCode.Unsupported, info.Path, -1, "attributes beyond those of LAS",
                    "at most " + ushort.MaxValue / LasExtraBytes.EntryBytes, extra.Count / LasExtraBytes.EntryBytes);
            if (extra.Count > 0)
                m_extraBytes = LasVlr.ToBytes(LasVlr.SpecificationUser, LasVlr.ExtraBytesRecord, "Extra bytes", extra.ToArray());
        }

        /// <summary>Extra bytes whose description was kept: it says more than names, and of several as one.</summary>
        void MapDescribed(PointSchema schema, string[] chosen, List<byte> extra)
        {
            if (m_records == null)
                return;
            foreach (var (entry, fields) in m_records.ExtraBytes)
            {
                bool isWhole = fields.Count > 0;
                foreach (var field in fields)
                    isWhole &= schema.IndexOf(field.Name) is int index && index >= 0 && IsChosen(field.Name, chosen) &&
                        schema[index].Equals(new PointAttribute(field.Name, field.Type, field.Scale, field.Offset));
                if (!isWhole)
                    continue;
                foreach (var field in fields)
                {
                    var to = new PointField(field.Name, field.Type, RecordBytes, field.Scale, field.Offset);
                    Columns.Add(new ExportColumn { From = field.Name, To = to });
                    RecordBytes += field.Type.SizeOf();
                }
                extra.AddRange(entry);
            }
        }

        bool IsUndescribed(PointAttribute attribute) => m_records?.UndescribedBytes > 0 &&
            attribute.Type == AttributeType.UInt8 &&
            attribute.Name.StartsWith(LasRecordLayout.UndescribedName, StringComparison.Ordinal);

        /// <summary>Whether the field holds all values of the attribute's type.</summary>
        bool Fits(PointAttribute attribute, ExportColumn column)
        {
            if (attribute.Scale != 1 || attribute.Offset != 0)
                return false;
            bool isColor = attribute.Name == AttributeNames.Red || attribute.Name == AttributeNames.Green ||
                attribute.Name == AttributeNames.Blue;
            if (isColor && attribute.Type == AttributeType.UInt8)
            {
                column.Scale = 257;
                if (attribute.Name == AttributeNames.Red)
                    Warnings.Add("colours of 8 bits are written times 257, since those of LAS have 16");
                return true;
            }
            // The field of formats 6 to 10 counts 0.006 degrees, that of 0 to 5 whole ones.
            if (attribute.Name == AttributeNames.ScanAngle && attribute.Type == AttributeType.Int8 &&
                column.To.Type == AttributeType.Int16)
                column.Scale = 1 / 0.006;
            return attribute.Type == column.To.Type || attribute.Type.SizeOf() < 8 &&
                AttributeTypes.Common(attribute.Type, column.To.Type) == column.To.Type;
        }

        /// <summary>Takes the records around the points over, as bytes: all but those that describe the points' compression, or
        /// an octree that the export has no more.</summary>
        void CopyRecords(LasFile las, bool keepsExtraBytes)
        {
            using var source = RandomAccessFile.Open(las.Info.Path);
            long bytes = 0, tail = 0;
            foreach (var vlr in las.Vlrs.Records)
            {
                long length = vlr.DataOffset + vlr.DataBytes - vlr.Offset;
                if (vlr.DescribesStorage || las.Info.IsCrsOverridden && vlr.IsCrs ||
                    !keepsExtraBytes && vlr.Is(LasVlr.SpecificationUser, LasVlr.ExtraBytesRecord))
                    continue;
                if (vlr.IsExtended)
                {
                    if ((ulong)vlr.Offset == las.Header.WaveformOffset)
                        m_waveformInTail = tail;
                    m_tail.Add((vlr.Offset, length));
                    tail += length;
                    m_evlrs++;
                }
                else if ((bytes += length) <= MaxVlrBytes)
                    m_vlrs.Add(source.Read(vlr.Offset, (int)length, "VLR").Bytes);
            }
            if (bytes > MaxVlrBytes)
                Losses.Add(new Loss("records", m_path, "more than 64 MiB of them lie before the points"));
            // LAS 1.3 has no list of such records, only the place of this one.
            ulong waveformOffset = las.Header.WaveformOffset;
            if (m_waveformInTail >= 0 || waveformOffset <= las.Header.PointsOffset ||
                waveformOffset + LasVlr.ExtendedHeaderBytes > (ulong)source.Length)
                return;
            var record = source.Read((long)waveformOffset, LasVlr.ExtendedHeaderBytes, "waveform record");
            ulong data = record.UInt64(20, "waveform bytes");
            ulong room = (ulong)source.Length - waveformOffset - LasVlr.ExtendedHeaderBytes;
            m_waveformInTail = tail;
            m_tail.Add(((long)waveformOffset, LasVlr.ExtendedHeaderBytes + (long)Math.Min(data, room)));
        }

        /// <summary>Adds the records that the source kept, except those of extra bytes, which are new, and those of a coordinate
        /// system that was overridden since.</summary>
        void AddRecords(CoordinateSystem crs, string[] chosen)
        {
            bool hasCrs = m_records != null && m_records.Crs.HasSameCodes(crs);
            foreach (var record in m_records?.All ?? Array.Empty<LasMetadata.Record>())
            {
                if (record.Vlr.IsCrs && !hasCrs)
                    continue;
                if (record.Vlr.IsExtraBytes && (m_extraBytes != null || chosen != null))
                {
                    if (m_extraBytes == null || !record.Payload.AsSpan().SequenceEqual(m_extraBytes.AsSpan(LasVlr.HeaderBytes)))
                        continue;
                    m_extraBytes = null;
                }
                (record.IsExtended ? m_tailBytes : m_vlrs).Add(record.Bytes);
                m_evlrs += record.IsExtended ? 1u : 0;
            }
            if (m_extraBytes != null)
                m_vlrs.Add(m_extraBytes);
            if (m_evlrs > 0)
                Header.VersionMinor = Math.Max(Header.VersionMinor, 4);
            if (hasCrs)
            {
                WarnOfKeysAlone(m_records.Crs);
                return;
            }
            AddNewCrs(crs);
        }

        void AddNewCrs(CoordinateSystem crs)
        {
            Header.GlobalEncoding &= unchecked((ushort)~LasHeader.WktBit);
            AddCrs(crs);
        }

        void AddTime(SourceInfo info)
        {
            var time = info.GpsTime;
            bool isKept = m_records != null && m_records.GpsTime.Equals(time);
            if (isKept && (time.Kind == GpsTimeKind.Unknown || time.Kind == GpsTimeKind.Offset && Header.VersionMinor >= 5))
                return;
            Header.GlobalEncoding &= unchecked((ushort)~(LasHeader.StandardTimeBit | LasHeader.TimeOffsetBit));
            bool isStandard = time.Kind == GpsTimeKind.AdjustedStandard ||
                time.Kind == GpsTimeKind.Offset && time.OffsetMegaseconds == StandardOffsetMegaseconds;
            if (isStandard)
                Header.GlobalEncoding |= LasHeader.StandardTimeBit;
            else if (time.Kind != GpsTimeKind.Week && Columns.Exists(c => c.To.Name == AttributeNames.GpsTime))
                Losses.Add(new Loss(time.ToString(), info.Path, "LAS 1." + Header.VersionMinor + " has no place for it: the " +
                    "numbers are kept, and readers take them for seconds of the week"));
        }

        void AddCrs(CoordinateSystem crs)
        {
            var wkt = Encoding.UTF8.GetBytes((crs.Wkt ?? "") + "\0");
            bool isExtended = Header.PointFormat >= LasPointFormat.FirstExtended;
            bool hasWkt = crs.Wkt != null && wkt.Length <= ushort.MaxValue;
            if (hasWkt)
                m_vlrs.Add(LasVlr.ToBytes(LasVlr.ProjectionUser, LasVlr.WktRecord, "OGC WKT", wkt));
            // Of a file that has both, the keys are for readers that know no WKT.
            if (hasWkt && (isExtended || crs.GeoKeys == null))
                Header.GlobalEncoding |= LasHeader.WktBit;
            for (int i = 0; crs.GeoKeys != null && i < LasGeoKeys.RecordIds.Length; i++)
                if (crs.GeoKeys[i].Length > 0)
                    m_vlrs.Add(LasVlr.ToBytes(LasVlr.ProjectionUser, LasGeoKeys.RecordIds[i], "GeoTIFF keys", crs.GeoKeys[i]));
            if (hasWkt || crs.GeoKeys != null)
            {
                WarnOfKeysAlone(hasWkt ? crs : new CoordinateSystem { GeoKeys = crs.GeoKeys });
            }
            else if (crs.Epsg != 0 || crs.VerticalEpsg != 0)
            {
                m_vlrs.Add(LasVlr.ToBytes(LasVlr.ProjectionUser, LasVlr.GeoKeyDirectoryRecord, "GeoTIFF keys",
                    LasGeoKeys.Directory(crs)));
                WarnOfKeysAlone(crs);
            }
            else if (crs.IsKnown)
            {
                Losses.Add(new Loss("the coordinate system " + crs.Summary, m_path, "LAS has no place for a name alone"));
            }
            else if (crs.Units.IsKnown)
            {
                Losses.Add(new Loss("the unit, " + crs.Units.Describe(BoundsGeo.Empty), m_path,
                    "LAS has a place for it in a coordinate system alone"));
            }
        }

        void WarnOfKeysAlone(CoordinateSystem crs)
        {
            if (crs.Wkt == null && (crs.GeoKeys != null || crs.Epsg != 0) && Header.PointFormat >= LasPointFormat.FirstExtended)
                Losses.Add(new Loss("the coordinate system as WKT, which point format " + Header.PointFormat + " wants", m_path,
                    "it is known by keys or a code alone, which are written as keys: readers that go by the letter see none"));
        }
    }
}
