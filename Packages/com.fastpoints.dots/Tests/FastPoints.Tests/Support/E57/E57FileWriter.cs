using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Text;
using FastPoints.Tests.Text;

namespace FastPoints.Tests
{
    /// <summary>Writes E57 files for tests, after ASTM E2807-11 and with none of the reader's code: pages with CRC-32C,
    /// bit-packed bytestreams in data packets, index and ignored packets, the XML section behind the binary ones.</summary>
    sealed class E57FileWriter
    {
        const int PageBytes = 1024, DataBytes = 1020, MaxStreamBytes = 65000;

        public readonly List<E57TestScan> Scans = new List<E57TestScan>();
        public string RootXml = "";

        public Func<string, string> EditXml = xml => xml;

        public E57FileWriter(params E57TestScan[] scans) => Scans.AddRange(scans);

        public byte[] ToArray()
        {
            var content = new MemoryStream();
            content.SetLength(48);
            content.Position = 48;
            var offsets = new List<long>();
            foreach (var scan in Scans)
                offsets.Add(WriteSection(content, scan));
            byte[] xml = Encoding.UTF8.GetBytes(EditXml(Xml(offsets)));
            long xmlOffset = Physical(content.Position);
            content.Write(xml, 0, xml.Length);
            long pages = (content.Length + DataBytes - 1) / DataBytes;
            content.Position = 0;
            Write(content, Encoding.ASCII.GetBytes("ASTM-E57"), 1U, 0U, (ulong)(pages * PageBytes), (ulong)xmlOffset,
                (ulong)xml.Length, (ulong)PageBytes);
            return Paged(content.ToArray());
        }

        public static void Seal(byte[] file)
        {
            for (int page = 0; page + PageBytes <= file.Length; page += PageBytes)
            {
                uint crc = Crc32C(file, page, DataBytes);
                for (int i = 0; i < 4; i++)
                    file[page + DataBytes + i] = (byte)(crc >> (24 - 8 * i));
            }
        }

        public static uint Crc32C(byte[] bytes, int first, int count)
        {
            uint crc = uint.MaxValue;
            for (int i = first; i < first + count; i++)
            {
                crc ^= bytes[i];
                for (int bit = 0; bit < 8; bit++)
                    crc = (crc & 1) != 0 ? crc >> 1 ^ 0x82F63B78U : crc >> 1;
            }
            return ~crc;
        }

        public static long Physical(long logical) => logical / DataBytes * PageBytes + logical % DataBytes;

        static byte[] Paged(byte[] content)
        {
            int pages = (content.Length + DataBytes - 1) / DataBytes;
            var file = new byte[pages * PageBytes];
            for (int page = 0; page < pages; page++)
                Array.Copy(content, page * DataBytes, file, page * PageBytes,
                    Math.Min(DataBytes, content.Length - page * DataBytes));
            Seal(file);
            return file;
        }

        static long WriteSection(MemoryStream content, E57TestScan scan)
        {
            long start = content.Position;
            Write(content, (byte)1, new byte[7], 0UL, (ulong)Physical(start + 32), 0UL);
            long index = 0;
            var streams = new List<byte[]>();
            foreach (var field in scan.Fields)
                streams.Add(Packed(field));
            var done = new int[streams.Count];
            var random = new Random(7);
            for (int packet = 0; IsMore(streams, done); packet++)
            {
                var counts = new int[streams.Count];
                for (int i = 0; i < counts.Length; i++)
                    counts[i] = Take(scan, i, packet, streams, done, random);
                WriteData(content, streams, done, counts, scan.HasRestartFlag && packet == 0);
                if (scan.HasIgnored && packet % 3 == 1)
                    Write(content, (byte)2, (byte)0, (ushort)11, new byte[8]);
            }
            if (scan.HasIndex)
            {
                index = Physical(content.Position);
                Write(content, (byte)0, (byte)0, (ushort)31, (ushort)1, (byte)0, new byte[9], 0UL, (ulong)Physical(start + 32));
            }
            long end = content.Position;
            content.Position = start + 8;
            Write(content, (ulong)(end - start), (ulong)Physical(start + 32), (ulong)index);
            content.Position = end;
            return Physical(start);
        }

        static int Take(E57TestScan scan, int stream, int packet, List<byte[]> streams, int[] done, Random random)
        {
            int left = streams[stream].Length - done[stream];
            switch (scan.Packing)
            {
                case E57Packing.Even:
                    long records = (packet + 1L) * scan.RecordsPerPacket;
                    long to = Math.Min(streams[stream].Length, records * scan.Fields[stream].Bits / 8);
                    bool isLast = records >= scan.Count;
                    return isLast ? left : (int)Math.Max(0, to - done[stream]);
                case E57Packing.Ragged:
                    return Math.Min(left, Math.Max(0, random.Next(-300, 2 * scan.RecordsPerPacket)));
                default:
                    for (int before = 0; before < stream; before++)
                        if (done[before] < streams[before].Length)
                            return 0;
                    return Math.Min(left, scan.RecordsPerPacket);
            }
        }

        static bool IsMore(List<byte[]> streams, int[] done)
        {
            for (int i = 0; i < done.Length; i++)
                if (done[i] < streams[i].Length)
                    return true;
            return false;
        }

        static void WriteData(MemoryStream content, List<byte[]> streams, int[] done, int[] counts, bool isRestart)
        {
            int bytes = 6 + 2 * counts.Length;
            for (int i = 0; i < counts.Length; i++)
            {
                counts[i] = Math.Min(counts[i], MaxStreamBytes / counts.Length);
                bytes += counts[i];
            }
            int padding = (4 - bytes % 4) % 4;
            Write(content, (byte)1, (byte)(isRestart ? 1 : 0), (ushort)(bytes + padding - 1), (ushort)counts.Length);
            foreach (int count in counts)
                Write(content, (ushort)count);
            for (int i = 0; i < counts.Length; i++)
            {
                content.Write(streams[i], done[i], counts[i]);
                done[i] += counts[i];
            }
            content.Write(new byte[padding], 0, padding);
        }

        static byte[] Packed(E57TestField field)
        {
            int bits = field.Bits;
            var bytes = new byte[((long)field.Count * bits + 7) / 8];
            for (int i = 0; i < field.Count; i++)
            {
                ulong raw = field.RawOf(i);
                for (int b = 0; b < bits; b++)
                    if ((raw >> b & 1) != 0)
                    {
                        long at = (long)i * bits + b;
                        bytes[at >> 3] |= (byte)(1 << (int)(at & 7));
                    }
            }
            return bytes;
        }

        string Xml(List<long> offsets)
        {
            var xml = new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<e57Root type=\"Structure\" " +
                "xmlns=\"http://www.astm.org/COMMIT/E57/2010-e57-v1.0\" " +
                "xmlns:nor=\"http://www.libe57.org/E57_NOR_surface_normals.txt\">\n" +
                "<formatName type=\"String\"><![CDATA[ASTM E57 3D Imaging Data File]]></formatName>\n" +
                "<guid type=\"String\"><![CDATA[{test}]]></guid>\n<versionMajor type=\"Integer\">1</versionMajor>\n" +
                "<versionMinor type=\"Integer\"/>\n" + RootXml + "<data3D type=\"Vector\" allowHeterogeneousChildren=\"1\">\n");
            for (int i = 0; i < Scans.Count; i++)
            {
                var scan = Scans[i];
                xml.Append("<vectorChild type=\"Structure\">\n<guid type=\"String\"><![CDATA[{scan").Append(i)
                    .Append("}]]></guid>\n").Append(scan.Xml).Append("\n<points type=\"CompressedVector\" fileOffset=\"")
                    .Append(scan.FileOffset ?? offsets[i].ToString(CultureInfo.InvariantCulture)).Append("\" recordCount=\"")
                    .Append(scan.RecordCount ?? scan.Count.ToString(CultureInfo.InvariantCulture))
                    .Append("\">\n<prototype type=\"Structure\">\n");
                foreach (var field in scan.Fields)
                    xml.Append(field.Element()).Append('\n');
                xml.Append("</prototype>\n<codecs type=\"Vector\" allowHeterogeneousChildren=\"1\"></codecs>\n" +
                    "</points>\n</vectorChild>\n");
            }
            return xml.Append("</data3D>\n</e57Root>\n").ToString();
        }

        static void Write(MemoryStream to, params object[] values)
        {
            foreach (object value in values)
            {
                byte[] bytes = value as byte[] ?? PlyTestFile.BytesOf(value);
                to.Write(bytes, 0, bytes.Length);
            }
        }
    }
}
