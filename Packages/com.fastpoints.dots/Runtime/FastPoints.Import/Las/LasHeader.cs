using System;
using System.Text;
using FastPoints.Reading;
using Unity.Mathematics;

namespace FastPoints.Las
{
    internal sealed class LasHeader
    {
        // The same in every version that has the field.
        public static class At
        {
            public const int FileSourceId = 4;
            public const int GlobalEncoding = 6;
            public const int Guid = 8;
            public const int VersionMajor = 24;
            public const int VersionMinor = 25;
            public const int SystemIdentifier = 26;
            public const int GeneratingSoftware = 58;
            public const int CreationDay = 90;
            public const int CreationYear = 92;
            public const int HeaderBytes = 94;
            public const int PointsOffset = 96;
            public const int VlrCount = 100;
            public const int PointFormat = 104;
            public const int RecordBytes = 105;
            public const int LegacyCount = 107;
            public const int LegacyByReturn = 111;
            public const int Scale = 131;
            public const int Offset = 155;
            // Maximum x, minimum x, maximum y, minimum y, maximum z, minimum z.
            public const int Bounds = 179;
            public const int WaveformOffset = 227;
            public const int EvlrOffset = 235;
            public const int EvlrCount = 243;
            public const int Count64 = 247;
            public const int ByReturn = 255;
            public const int MaxGpsTime = 375;
            public const int MinGpsTime = 383;
            public const int TimeOffset = 391;
        }

        public const string Magic = "LASF";
        public const int MaxMinorVersion = 5;
        public const int MinBytes = 227; // LAS 1.0 to 1.2: no file has a shorter header.

        const int TextBytes = 32;
        const byte CompressedBit = 0x80;
        const byte LayeredBit = 0x40;

        static readonly int[] s_bytesOfMinor = { 227, 227, 227, 235, 375, 393 };

        public ushort FileSourceId;
        public ushort GlobalEncoding;
        public const ushort StandardTimeBit = 1, WaveformBits = 6, WktBit = 1 << 4, TimeOffsetBit = 1 << 6;
        public byte[] Guid = new byte[16];
        public int VersionMinor;
        public string SystemIdentifier = "";
        public string GeneratingSoftware = "";
        public ushort CreationDay;
        public ushort CreationYear;
        public int HeaderBytes;
        public uint PointsOffset;
        public uint VlrCount;
        public int PointFormat;
        // LAZ: the points are not plain records of RecordBytes.
        public bool IsCompressed;
        public int RecordBytes;
        public uint LegacyCount;
        public readonly uint[] LegacyByReturn = new uint[5];
        public double3 Scale;
        public double3 Offset;
        public double3 Min;
        public double3 Max;
        // 0 before LAS 1.3.
        public ulong WaveformOffset;
        public ulong EvlrOffset;
        public uint EvlrCount;
        // 0 before LAS 1.4.
        public ulong Count64;
        public readonly ulong[] ByReturn = new ulong[15];
        // 0 before LAS 1.5, like the next two.
        public double MaxGpsTime;
        public double MinGpsTime;
        public ushort TimeOffset;

        public GpsTime GpsTime =>
            (GlobalEncoding & TimeOffsetBit) != 0 && HasBytes(BytesOf(5)) ? new GpsTime(GpsTimeKind.Offset, TimeOffset)
            : new GpsTime((GlobalEncoding & StandardTimeBit) != 0 ? GpsTimeKind.AdjustedStandard : GpsTimeKind.Week);

        public bool HasWaveforms => (GlobalEncoding & WaveformBits) != 0 || WaveformOffset != 0;

        public static int BytesOf(int minorVersion) => s_bytesOfMinor[minorVersion];

        // The version has the field that ends there, and the header is long enough for it.
        public bool HasBytes(int end) => end <= BytesOf(VersionMinor) && (end <= MinBytes || end <= HeaderBytes);

        public bool Has64BitCount => HasBytes(At.ByReturn);
        public ulong PointsClaimed => Has64BitCount && (Count64 != 0 || LegacyCount == 0) ? Count64 : LegacyCount;
        public int PointsClaimedAt => Has64BitCount && (Count64 != 0 || LegacyCount == 0) ? At.Count64 : At.LegacyCount;

        // Whatever makes the points unreadable is a failure; everything else is checked later.
        public static LasHeader Read(RandomAccessFile source)
        {
            if (source.ReadUpTo(0, 4).Text(0, (int)Math.Min(4, source.Length), "signature") != Magic)
                throw PointCloudException.Wanted(FailureCode.BadInput, source.Path, 0, "signature", Magic, "something else");
            source.Read(0, MinBytes, "LAS header");
            var bytes = source.ReadUpTo(0, BytesOf(MaxMinorVersion));
            int major = bytes.UInt8(At.VersionMajor, "version");
            int minor = bytes.UInt8(At.VersionMinor, "version");
            if (major != 1 || minor > MaxMinorVersion)
                throw PointCloudException.Wanted(FailureCode.Unsupported, source.Path, At.VersionMajor, "LAS version",
                    "1.0 to 1." + MaxMinorVersion, major + "." + minor);

            byte format = bytes.UInt8(At.PointFormat, "point format");
            var header = new LasHeader
            {
                FileSourceId = bytes.UInt16(At.FileSourceId, "file source id"),
                GlobalEncoding = bytes.UInt16(At.GlobalEncoding, "global encoding"),
                VersionMinor = minor,
                SystemIdentifier = bytes.Text(At.SystemIdentifier, TextBytes, "system identifier"),
                GeneratingSoftware = bytes.Text(At.GeneratingSoftware, TextBytes, "generating software"),
                CreationDay = bytes.UInt16(At.CreationDay, "creation day"),
                CreationYear = bytes.UInt16(At.CreationYear, "creation year"),
                HeaderBytes = bytes.UInt16(At.HeaderBytes, "header size"),
                PointsOffset = bytes.UInt32(At.PointsOffset, "offset to point data"),
                VlrCount = bytes.UInt32(At.VlrCount, "VLR count"),
                PointFormat = format & ~(CompressedBit | LayeredBit),
                IsCompressed = (format & CompressedBit) != 0,
                RecordBytes = bytes.UInt16(At.RecordBytes, "point record length"),
                LegacyCount = bytes.UInt32(At.LegacyCount, "point count"),
            };
            Array.Copy(bytes.Bytes, At.Guid, header.Guid, 0, header.Guid.Length);
            for (int i = 0; i < header.LegacyByReturn.Length; i++)
                header.LegacyByReturn[i] = bytes.UInt32(At.LegacyByReturn + 4 * i, "points by return");
            for (int axis = 0; axis < 3; axis++)
            {
                header.Scale[axis] = bytes.Float64(At.Scale + 8 * axis, "scale");
                header.Offset[axis] = bytes.Float64(At.Offset + 8 * axis, "offset");
                header.Max[axis] = bytes.Float64(At.Bounds + 16 * axis, "bounds");
                header.Min[axis] = bytes.Float64(At.Bounds + 16 * axis + 8, "bounds");
            }
            header.ReadLaterFields(bytes);
            header.CheckFormat(source.Path, format);
            return header;
        }

        void ReadLaterFields(ByteReader bytes)
        {
            if (HasBytes(At.EvlrOffset))
                WaveformOffset = bytes.UInt64(At.WaveformOffset, "start of waveform data");
            if (Has64BitCount)
            {
                EvlrOffset = bytes.UInt64(At.EvlrOffset, "start of the first EVLR");
                EvlrCount = bytes.UInt32(At.EvlrCount, "EVLR count");
                Count64 = bytes.UInt64(At.Count64, "point count");
            }
            if (HasBytes(At.MaxGpsTime))
                for (int i = 0; i < ByReturn.Length; i++)
                    ByReturn[i] = bytes.UInt64(At.ByReturn + 8 * i, "points by return");
            if (HasBytes(BytesOf(5)))
            {
                MaxGpsTime = bytes.Float64(At.MaxGpsTime, "largest GPS time");
                MinGpsTime = bytes.Float64(At.MinGpsTime, "smallest GPS time");
                TimeOffset = bytes.UInt16(At.TimeOffset, "time offset");
            }
        }

        void CheckFormat(string path, byte formatByte)
        {
            if (PointFormat >= LasPointFormat.Count)
                throw PointCloudException.Wanted(FailureCode.Unsupported, path, At.PointFormat, "point format", "0 to 10",
                    formatByte);
            int min = LasPointFormat.Of(PointFormat).RecordBytes;
            if (RecordBytes < min)
                throw PointCloudException.Wanted(FailureCode.BadInput, path, At.RecordBytes,
                    "record length of point format " + PointFormat, "at least " + min, RecordBytes);
            if (PointsOffset < MinBytes)
                throw PointCloudException.Wanted(FailureCode.BadInput, path, At.PointsOffset, "offset to point data",
                    "at least " + MinBytes, PointsOffset);
        }

        public byte[] ToBytes()
        {
            var bytes = new byte[BytesOf(VersionMinor)];
            Encoding.ASCII.GetBytes(Magic).CopyTo(bytes, 0);
            Put(bytes, At.FileSourceId, 2, FileSourceId);
            Put(bytes, At.GlobalEncoding, 2, GlobalEncoding);
            Guid.CopyTo(bytes, At.Guid);
            bytes[At.VersionMajor] = 1;
            bytes[At.VersionMinor] = (byte)VersionMinor;
            PutText(bytes, At.SystemIdentifier, TextBytes, SystemIdentifier);
            PutText(bytes, At.GeneratingSoftware, TextBytes, GeneratingSoftware);
            Put(bytes, At.CreationDay, 2, CreationDay);
            Put(bytes, At.CreationYear, 2, CreationYear);
            Put(bytes, At.HeaderBytes, 2, (ulong)bytes.Length);
            Put(bytes, At.PointsOffset, 4, PointsOffset);
            Put(bytes, At.VlrCount, 4, VlrCount);
            bytes[At.PointFormat] = (byte)(PointFormat | (IsCompressed ? CompressedBit : 0));
            Put(bytes, At.RecordBytes, 2, (ulong)RecordBytes);
            Put(bytes, At.LegacyCount, 4, LegacyCount);
            for (int i = 0; i < LegacyByReturn.Length; i++)
                Put(bytes, At.LegacyByReturn + 4 * i, 4, LegacyByReturn[i]);
            for (int axis = 0; axis < 3; axis++)
            {
                PutFloat(bytes, At.Scale + 8 * axis, Scale[axis]);
                PutFloat(bytes, At.Offset + 8 * axis, Offset[axis]);
                PutFloat(bytes, At.Bounds + 16 * axis, Max[axis]);
                PutFloat(bytes, At.Bounds + 16 * axis + 8, Min[axis]);
            }
            if (bytes.Length >= At.EvlrOffset)
                Put(bytes, At.WaveformOffset, 8, WaveformOffset);
            if (bytes.Length >= At.MaxGpsTime)
            {
                Put(bytes, At.EvlrOffset, 8, EvlrOffset);
                Put(bytes, At.EvlrCount, 4, EvlrCount);
                Put(bytes, At.Count64, 8, Count64);
                for (int i = 0; i < ByReturn.Length; i++)
                    Put(bytes, At.ByReturn + 8 * i, 8, ByReturn[i]);
            }
            if (bytes.Length >= BytesOf(5))
            {
                PutFloat(bytes, At.MaxGpsTime, MaxGpsTime);
                PutFloat(bytes, At.MinGpsTime, MinGpsTime);
                Put(bytes, At.TimeOffset, 2, TimeOffset);
            }
            return bytes;
        }

        // byReturn: by return number, from 0; min and max: of the stored coordinates. Unsupported if the version has no room.
        public void SetCountsAndBounds(string path, ulong[] byReturn, int3 min, int3 max)
        {
            bool fitsLegacy = Count64 <= uint.MaxValue;
            if (!fitsLegacy && VersionMinor < 4)
                throw PointCloudException.Wanted(FailureCode.Unsupported, path, -1, "points in LAS 1." + VersionMinor,
                    "at most " + uint.MaxValue, Count64);
            // LAS 1.4: the 32-bit counts are 0 for point formats that older readers do not know.
            bool legacy = fitsLegacy && PointFormat < LasPointFormat.FirstExtended;
            LegacyCount = legacy ? (uint)Count64 : 0;
            for (int i = 0; i < LegacyByReturn.Length; i++)
                LegacyByReturn[i] = legacy ? (uint)byReturn[i + 1] : 0;
            for (int i = 0; i < ByReturn.Length; i++)
                ByReturn[i] = byReturn[i + 1];
            if (Count64 == 0)
                return;
            // A negative scale reverses the axis.
            var a = new double3(min.x, min.y, min.z) * Scale + Offset;
            var b = new double3(max.x, max.y, max.z) * Scale + Offset;
            Min = math.min(a, b);
            Max = math.max(a, b);
        }

        internal static void Put(byte[] bytes, int at, int count, ulong value)
        {
            for (int i = 0; i < count; i++)
                bytes[at + i] = (byte)(value >> 8 * i);
        }

        internal static void PutFloat(byte[] bytes, int at, double value) =>
            Put(bytes, at, 8, (ulong)BitConverter.DoubleToInt64Bits(value));

        // Cut to the field's length and padded with zeros.
        internal static void PutText(byte[] bytes, int at, int count, string text)
        {
            for (int i = 0; i < count && i < text.Length; i++)
                bytes[at + i] = text[i] < 128 ? (byte)text[i] : (byte)'?';
        }
    }
}
