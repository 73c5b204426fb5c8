using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

namespace FastPoints.Tests
{
    static class KeyFields
    {
        public static List<(int At, int Bytes)> Of(byte[] file)
        {
            var places = new List<(int At, int Bytes)>();
            if (StartsWith(file, "LASF"))
                AddLas(file, places);
            else if (StartsWith(file, "ASTM-E57"))
                AddE57(file, places);
            return places.Where(p => p.At >= 0 && p.Bytes > 0 && p.At + p.Bytes <= file.Length).ToList();
        }

        static bool StartsWith(byte[] file, string magic) =>
            file.Length > 300 && Encoding.ASCII.GetString(file, 0, magic.Length) == magic;

        static void AddLas(byte[] file, List<(int At, int Bytes)> places)
        {
            const int PointsOffset = 96, Format = 104, RecordBytes = 105, Evlrs = 235, CompressedBits = 0xC0;
            const int LayerSizes = 44, TableBytes = 40;
            places.Add((PointsOffset, 20));
            int points = BitConverter.ToInt32(file, PointsOffset);
            if ((file[Format] & CompressedBits) == 0)
                return;
            places.Add((points, 8));
            places.Add((points + 8 + BitConverter.ToUInt16(file, RecordBytes), LayerSizes));
            long table = BitConverter.ToInt64(file, points);
            if (table == -1)
                table = BitConverter.ToInt64(file, file.Length - 8);
            places.Add(((int)table, Math.Min(TableBytes, file.Length - (int)table)));
            bool hasEvlrs = BitConverter.ToUInt16(file, 94) >= 375;
            int evlr = hasEvlrs ? (int)BitConverter.ToInt64(file, Evlrs) : 0;
            if (evlr <= 0)
                return;
            // The info VLR of COPC is the first one; its pages are the extended VLR.
            places.Add((Evlrs, 12));
            places.Add((375 + 54, 72));
            places.Add((evlr, file.Length - evlr));
        }

        static void AddE57(byte[] file, List<(int At, int Bytes)> places)
        {
            const int Lengths = 16, XmlOffset = 24, FirstSection = 48, SectionBytes = 32, PacketBytes = 24;
            int xml = (int)BitConverter.ToInt64(file, XmlOffset);
            places.Add((Lengths, 32));
            places.Add((FirstSection, SectionBytes + PacketBytes));
            places.Add((xml, file.Length - xml));
        }
    }
}
