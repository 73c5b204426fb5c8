using System;
using System.Collections.Generic;
using System.Globalization;
using FastPoints.Reading;
using Unity.Mathematics;

namespace FastPoints.Las
{
    // A header's claims against what the file can hold. Differences are warnings; the file wins.
    internal static class LasClaims
    {
        // Truncated if points are claimed, but there are none.
        public static long CountReadable(LasHeader header, long fileBytes, SourceInfo info)
        {
            ulong claimed = header.PointsClaimed;
            if (header.Has64BitCount && header.LegacyCount != 0 && header.LegacyCount != header.Count64)
                info.Warn(LasHeader.At.LegacyCount, "the 32-bit point count is " + NumberText.Of(header.LegacyCount)
                    + ", the 64-bit one " + NumberText.Of(header.Count64) + ": " + NumberText.Of(claimed) + " is used");
            if (header.PointsOffset < header.HeaderBytes)
                info.Warn(LasHeader.At.PointsOffset, "the points start at byte " + NumberText.Of(header.PointsOffset)
                    + ", inside the header of " + NumberText.Of((ulong)header.HeaderBytes) + " bytes");

            long start = header.PointsOffset;
            long room = Math.Max(0, fileBytes - start);
            if (claimed <= (ulong)(room / header.RecordBytes))
            {
                CheckTrailing(header, start + (long)claimed * header.RecordBytes, fileBytes, info);
                return (long)claimed;
            }

            long end = Math.Min(NextSection(header.WaveformOffset, start, fileBytes),
                NextSection(header.EvlrCount > 0 ? header.EvlrOffset : 0, start, fileBytes));
            long bytes = Math.Max(0, end - start);
            long readable = bytes / header.RecordBytes;
            long cut = bytes % header.RecordBytes;
            string detail = "the header claims " + NumberText.Of(claimed) + " points, the file holds "
                + NumberText.Of((ulong)readable)
                + (cut == 0 ? "" : " and " + NumberText.Of((ulong)cut) + " of the " + NumberText.Of((ulong)header.RecordBytes)
                    + " bytes of the next");
            if (readable == 0)
                throw new PointCloudException(FailureCode.Truncated, info.Path, start, detail);
            info.Warn(header.PointsClaimedAt, detail);
            return readable;
        }

        // The claimed box against what integers, scale and offset can express, and the first, middle and last point.
        public static void CheckBounds(LasHeader header, RandomAccessFile source, long readable, SourceInfo info)
        {
            var records = new List<long>();
            if (readable > 0)
                foreach (long index in new[] { 0, readable / 2, readable - 1 })
                    records.Add(header.PointsOffset + index * header.RecordBytes);
            CheckBounds(header, source, records, info);
        }

        public static void CheckBounds(LasHeader header, RandomAccessFile source, IReadOnlyList<long> records, SourceInfo info)
        {
            int readable = records.Count;
            var claimed = new BoundsGeo(header.Min, header.Max);
            if (!claimed.IsFinite || claimed.IsEmpty)
            {
                if (readable > 0)
                    info.Warn(LasHeader.At.Bounds, "bounds: wanted a box, got " + Text(claimed) + ": left out");
                return;
            }
            if (readable > 0 && math.all(claimed.Min == 0) && math.all(claimed.Max == 0))
            {
                info.Warn(LasHeader.At.Bounds, "the bounds are all zero: left out");
                return;
            }
            info.HasBoundsClaimed = true;
            info.BoundsClaimed = claimed;
            if (readable == 0)
                return;

            var raw = BoundsGeo.Empty;
            foreach (long offset in records)
            {
                var record = source.Read(offset, 12, "point");
                raw.Include(new double3(record.Int32(0, "X"), record.Int32(4, "Y"), record.Int32(8, "Z")));
            }
            var sampled = BoundsGeo.Empty;
            sampled.Include(info.Transform.ToGeo(raw.Min));
            sampled.Include(info.Transform.ToGeo(raw.Max));
            if (Contains(claimed, sampled, math.abs(info.Transform.Scale)))
                return;
            if (claimed.Contains(raw.Min) && claimed.Contains(raw.Max))
            {
                info.BoundsClaimed = BoundsGeo.Empty;
                info.BoundsClaimed.Include(info.Transform.ToGeo(claimed.Min));
                info.BoundsClaimed.Include(info.Transform.ToGeo(claimed.Max));
                info.Warn(LasHeader.At.Bounds, "the bounds are in raw integers, without scale and offset: read as "
                    + Text(info.BoundsClaimed));
                return;
            }
            info.Warn(LasHeader.At.Bounds, "the bounds " + Text(claimed) + " leave out points such as " + Text(sampled.Min));
        }

        static void CheckTrailing(LasHeader header, long pointsEnd, long fileBytes, SourceInfo info)
        {
            long end = fileBytes;
            var sections = new List<(ulong At, int Field, string Name)>
            {
                (header.WaveformOffset, LasHeader.At.WaveformOffset, "the waveform data"),
            };
            if (header.EvlrCount > 0)
                sections.Add((header.EvlrOffset, LasHeader.At.EvlrOffset, "the first EVLR"));
            foreach (var (at, field, name) in sections)
                if (at > header.PointsOffset && at < (ulong)pointsEnd)
                    info.Warn(field, name + " would start at byte " + NumberText.Of(at)
                        + ", among the points: the point count is believed");
                else if (at >= (ulong)pointsEnd && at < (ulong)end)
                    end = (long)at;
            long rest = end - pointsEnd;
            if (rest >= header.RecordBytes)
                info.Warn(header.PointsClaimedAt, "behind the " + NumberText.Of(header.PointsClaimed)
                    + " points that the header claims lie " + NumberText.Of((ulong)rest) + " bytes, room for "
                    + NumberText.Of((ulong)(rest / header.RecordBytes)) + " more");
            else if (rest > 0)
                info.AddFact("bytes behind the points", NumberText.Of((ulong)rest));
        }

        static long NextSection(ulong at, long start, long fileBytes) =>
            at > (ulong)start && at < (ulong)fileBytes ? (long)at : fileBytes;

        // Writers round the box to the step, or print it with few digits: two steps are not a contradiction.
        static bool Contains(BoundsGeo box, BoundsGeo sampled, double3 step) =>
            math.all(sampled.Min >= box.Min - 2 * step) && math.all(sampled.Max <= box.Max + 2 * step);

        static string Text(BoundsGeo box) => Text(box.Min) + " .. " + Text(box.Max);

        static string Text(double3 point) => "(" + NumberText.Of(point) + ")";
    }

    internal static class LasFacts
    {
        static readonly string[] s_encodingBits =
        {
            "GPS time is adjusted standard time", "waveforms inside the file", "waveforms in an auxiliary file",
            "synthetic return numbers", "CRS is WKT", "aggregate", "GPS time has an offset",
        };

        public static void Add(LasHeader header, LasVlrTable vlrs, SourceInfo info)
        {
            info.AddFactIfAny("system identifier", header.SystemIdentifier);
            info.AddFactIfAny("generating software", header.GeneratingSoftware);
            if (header.CreationYear != 0 || header.CreationDay != 0)
                info.AddFact("created", "day " + NumberText.Of(header.CreationDay) + " of " + NumberText.Of(header.CreationYear));
            info.AddFact("file source id", NumberText.Of(header.FileSourceId));
            info.AddFact("global encoding", Encoding(header.GlobalEncoding));
            var guid = new Guid(header.Guid);
            if (guid != Guid.Empty)
                info.AddFact("project GUID", guid.ToString());
            info.AddFact("header bytes", NumberText.Of((ulong)header.HeaderBytes));
            info.AddFact("offset to points", NumberText.Of(header.PointsOffset));
            info.AddFact("record bytes", NumberText.Of((ulong)header.RecordBytes));
            info.AddFact("scale", Numbers(header.Scale.x, header.Scale.y, header.Scale.z));
            info.AddFact("offset", Numbers(header.Offset.x, header.Offset.y, header.Offset.z));
            if (header.Has64BitCount && header.LegacyCount != 0)
                info.AddFact("32-bit point count", NumberText.Of(header.LegacyCount));
            info.AddFact("points by return", ByReturn(header));
            if (header.WaveformOffset != 0)
                info.AddFact("start of waveform data", NumberText.Of(header.WaveformOffset));
            if (header.HasBytes(LasHeader.BytesOf(5)))
            {
                info.AddFact("GPS time", Numbers(header.MinGpsTime, header.MaxGpsTime));
                info.AddFact("time offset", NumberText.Of(header.TimeOffset));
            }
            foreach (var record in vlrs.Records)
                info.AddFact(record.IsExtended ? "EVLR" : "VLR", record.UserId + "/" + NumberText.Of(record.RecordId) + ", "
                    + NumberText.Of((ulong)record.DataBytes) + " bytes"
                    + (record.Description.Length > 0 ? ", " + record.Description : ""));
        }

        static string Encoding(int bits)
        {
            var names = new List<string> { "0x" + bits.ToString("X4", CultureInfo.InvariantCulture) };
            for (int i = 0; i < s_encodingBits.Length; i++)
                if ((bits & 1 << i) != 0)
                    names.Add(s_encodingBits[i]);
            return string.Join(", ", names);
        }

        static string ByReturn(LasHeader header)
        {
            var counts = new List<string>();
            if (header.HasBytes(LasHeader.At.MaxGpsTime))
                foreach (ulong count in header.ByReturn)
                    counts.Add(NumberText.Of(count));
            else
                foreach (uint count in header.LegacyByReturn)
                    counts.Add(NumberText.Of(count));
            while (counts.Count > 1 && counts[counts.Count - 1] == "0")
                counts.RemoveAt(counts.Count - 1);
            return string.Join(" ", counts);
        }

        static string Numbers(params double[] values) => string.Join(" ", Array.ConvertAll(values, NumberText.Of));
    }
}
