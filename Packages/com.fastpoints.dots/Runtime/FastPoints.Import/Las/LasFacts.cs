using System;
using System.Collections.Generic;
using System.Globalization;
using FastPoints.Core;
using FastPoints.Reading;

namespace FastPoints.Las
{
    internal static class LasFacts
    {
        static readonly string[] s_encodingBits =
        {
            "GPS time is adjusted standard time", "waveforms inside the file", "waveforms in an auxiliary file",
            "synthetic return numbers", "CRS is WKT", "aggregate", "GPS time has an offset",
        };

        public static void Add(LasHeader header, LasVlrTable vlrs, SourceInfo info)
        {
            AddText("system identifier", header.SystemIdentifier, info);
            AddText("generating software", header.GeneratingSoftware, info);
            if (header.CreationYear != 0 || header.CreationDay != 0)
                info.Fact("created", "day " + NumberText.Of(header.CreationDay) + " of " + NumberText.Of(header.CreationYear));
            info.Fact("file source id", NumberText.Of(header.FileSourceId));
            info.Fact("global encoding", Encoding(header.GlobalEncoding));
            var guid = new Guid(header.Guid);
            if (guid != Guid.Empty)
                info.Fact("project GUID", guid.ToString());
            info.Fact("header bytes", NumberText.Of((ulong)header.HeaderBytes));
            info.Fact("offset to points", NumberText.Of(header.PointsOffset));
            info.Fact("record bytes", NumberText.Of((ulong)header.RecordBytes));
            info.Fact("scale", Numbers(header.Scale.x, header.Scale.y, header.Scale.z));
            info.Fact("offset", Numbers(header.Offset.x, header.Offset.y, header.Offset.z));
            if (header.Has64BitCount && header.LegacyCount != 0)
                info.Fact("32-bit point count", NumberText.Of(header.LegacyCount));
            info.Fact("points by return", ByReturn(header));
            if (header.WaveformOffset != 0)
                info.Fact("start of waveform data", NumberText.Of(header.WaveformOffset));
            if (header.HasBytes(LasHeader.BytesOf(5)))
            {
                info.Fact("GPS time", Numbers(header.MinGpsTime, header.MaxGpsTime));
                info.Fact("time offset", NumberText.Of(header.TimeOffset));
            }
            foreach (var record in vlrs.Records)
                info.Fact(record.IsExtended ? "EVLR" : "VLR", record.UserId + "/" + NumberText.Of(record.RecordId) + ", "
                    + NumberText.Of((ulong)record.DataBytes) + " bytes"
                    + (record.Description.Length > 0 ? ", " + record.Description : ""));
        }

        static void AddText(string name, string value, SourceInfo info)
        {
            if (value.Length > 0)
                info.Fact(name, value);
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
