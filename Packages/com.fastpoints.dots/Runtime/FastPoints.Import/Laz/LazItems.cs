using System;
using System.Collections.Generic;
using System.IO;
using System.Text;

namespace FastPoints.Laz
{
    // The parts of a record that are compressed each in its own way.
    internal static class LazItems
    {
        // version: 1 or 2 for point formats 0 to 5, 3 or 4 above.
        public static LazItem[] Of(int pointFormat, int version, int extraBytes)
        {
            var items = new List<LazItem>();
            bool isExtended = pointFormat >= 6;
            int at = 0;
            foreach (string name in LazFormat.ItemsOf(pointFormat).Split(new[] { " + " }, StringSplitOptions.None))
                Add(items, (LazItemType)Enum.Parse(typeof(LazItemType), name), version, 0, ref at);
            if (extraBytes > 0)
                Add(items, isExtended ? LazItemType.Bytes14 : LazItemType.Bytes, version, extraBytes, ref at);
            return items.ToArray();
        }

        static void Add(List<LazItem> items, LazItemType type, int version, int bytes, ref int at)
        {
            int fixedBytes = LazItem.FixedBytes(type);
            var item = new LazItem
            {
                Type = type,
                // Wave packets of pointwise chunks have one version only.
                Version = type == LazItemType.WavePacket13 ? 1 : version,
                Bytes = fixedBytes != 0 ? fixedBytes : bytes,
                RecordOffset = at,
            };
            items.Add(item);
            at += item.Bytes;
        }

        public static byte[] Vlr(LazItem[] items, LazCompressor compressor, uint chunkPoints)
        {
            var vlr = new BinaryWriter(new MemoryStream());
            vlr.Write((ushort)0);
            vlr.Write(Padded(LazFormat.UserId, 16));
            vlr.Write(LazFormat.RecordId);
            vlr.Write((ushort)(34 + 6 * items.Length));
            vlr.Write(Padded("", 32));
            vlr.Write((ushort)compressor);
            vlr.Write((ushort)0);
            vlr.Write(new byte[] { 3, 4, 0, 0 });
            vlr.Write(0u);
            vlr.Write(chunkPoints);
            vlr.Write(-1L);
            vlr.Write(-1L);
            vlr.Write((ushort)items.Length);
            foreach (var item in items)
            {
                vlr.Write((ushort)item.Type);
                vlr.Write((ushort)item.Bytes);
                vlr.Write((ushort)item.Version);
            }
            return ((MemoryStream)vlr.BaseStream).ToArray();
        }

        static byte[] Padded(string text, int count)
        {
            var bytes = new byte[count];
            Encoding.ASCII.GetBytes(text).CopyTo(bytes, 0);
            return bytes;
        }
    }
}
