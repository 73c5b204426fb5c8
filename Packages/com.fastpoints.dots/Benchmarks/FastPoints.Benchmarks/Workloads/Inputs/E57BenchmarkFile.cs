using System;
using System.IO;
using System.Text;
using FastPoints.E57;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Benchmarks
{
    /// <summary>The seeded E57 file that the workloads read: one scan of a hilly surface as scanners write them, scaled integers
    /// of 21 bits, colours of 8, intensity of 12, and a state that one point in 64 has as invalid.</summary>
    static unsafe class E57BenchmarkFile
    {
        public const int PageBytes = 1024;
        const int DataBytes = 1020;
        const int PacketRecords = 4096; // A multiple of eight, so that every bytestream of a packet ends with a byte.
        const int HeaderBytes = 48, SectionHeaderBytes = 32, PositionBits = 21;
        public const int BytesPerPoint = 13; // 100 bits, nearly.

        static readonly int[] s_bits = { PositionBits, PositionBits, PositionBits, 8, 8, 8, 12, 1 };

        sealed class Pages : IDisposable
        {
            readonly FileStream m_stream;
            readonly Crc32C m_crc = new Crc32C(Allocator.Persistent);
            readonly byte[] m_page = new byte[PageBytes];
            byte[] m_firstPage;

            public Pages(string path) =>
                m_stream = new FileStream(path, FileMode.Create, FileAccess.ReadWrite, FileShare.None, 1 << 20);

            public long Length { get; private set; }

            public void Write(byte[] bytes, int count)
            {
                for (int done = 0; done < count;)
                {
                    int at = (int)(Length % DataBytes), piece = Math.Min(DataBytes - at, count - done);
                    Buffer.BlockCopy(bytes, done, m_page, at, piece);
                    done += piece;
                    Length += piece;
                    if (at + piece == DataBytes)
                        Flush();
                }
            }

            public void Complete(byte[] header)
            {
                if (Length % DataBytes != 0)
                    Flush();
                Buffer.BlockCopy(header, 0, m_firstPage, 0, header.Length);
                Buffer.BlockCopy(m_firstPage, 0, m_page, 0, PageBytes);
                m_stream.Position = 0;
                Flush();
            }

            void Flush()
            {
                uint crc = m_crc.Of(m_page, 0, DataBytes);
                for (int i = 0; i < 4; i++)
                    m_page[DataBytes + i] = (byte)(crc >> (24 - 8 * i));
                m_stream.Write(m_page, 0, PageBytes);
                m_firstPage = m_firstPage ?? (byte[])m_page.Clone();
                Array.Clear(m_page, 0, PageBytes);
            }

            public void Dispose()
            {
                m_stream.Dispose();
                m_crc.Dispose();
            }
        }

        public static string Make(WorkloadContext context)
        {
            string path = context.PathOf("hills", ".e57");
            if (File.Exists(path))
                return path;
            using var pages = new Pages(path);
            pages.Write(new byte[HeaderBytes], HeaderBytes);
            long packets = (context.Points + PacketRecords - 1) / PacketRecords;
            pages.Write(SectionHeader(context.Points, packets), SectionHeaderBytes);
            var random = new Unity.Mathematics.Random(context.Seed);
            var packet = new byte[1 << 16];
            var records = new uint[PacketRecords * s_bits.Length];
            for (long first = 0; first < context.Points; first += PacketRecords)
            {
                int count = (int)Math.Min(PacketRecords, context.Points - first);
                Fill(records, first, count, context.Points, ref random);
                pages.Write(packet, Pack(records, count, packet));
            }
            byte[] xml = Encoding.UTF8.GetBytes(Xml(context.Points));
            long xmlOffset = pages.Length;
            pages.Write(xml, xml.Length);
            long pageCount = (pages.Length + DataBytes - 1) / DataBytes;
            pages.Complete(Header(pageCount * PageBytes, Physical(xmlOffset), xml.Length));
            return path;
        }

        static long Physical(long logical) => logical / DataBytes * PageBytes + logical % DataBytes;

        static int PacketBytes(int records)
        {
            int bytes = 6 + 2 * s_bits.Length;
            foreach (int bits in s_bits)
                bytes += (records * bits + 7) / 8;
            return (bytes + 3) / 4 * 4;
        }

        static byte[] Header(long fileBytes, long xmlOffset, long xmlBytes)
        {
            var bytes = new byte[HeaderBytes];
            Encoding.ASCII.GetBytes("ASTM-E57").CopyTo(bytes, 0);
            bytes[8] = 1;
            BitConverter.GetBytes(fileBytes).CopyTo(bytes, 16);
            BitConverter.GetBytes(xmlOffset).CopyTo(bytes, 24);
            BitConverter.GetBytes(xmlBytes).CopyTo(bytes, 32);
            BitConverter.GetBytes((long)PageBytes).CopyTo(bytes, 40);
            return bytes;
        }

        static byte[] SectionHeader(long points, long packets)
        {
            var bytes = new byte[SectionHeaderBytes];
            long last = points - (packets - 1) * PacketRecords;
            bytes[0] = 1;
            BitConverter.GetBytes(SectionHeaderBytes + (packets - 1) * PacketBytes(PacketRecords) + PacketBytes((int)last))
                .CopyTo(bytes, 8);
            BitConverter.GetBytes((long)HeaderBytes + SectionHeaderBytes).CopyTo(bytes, 16);
            return bytes;
        }

        static void Fill(uint[] records, long first, int count, long points, ref Unity.Mathematics.Random random)
        {
            double side = math.sqrt((double)points), step = ((1 << PositionBits) - 1) / side;
            for (int i = 0; i < count; i++)
            {
                double x = (first + i) % (long)side + random.NextDouble(), y = (first + i) / (long)side + random.NextDouble();
                double height = math.sin(x / side * 9) * math.cos(y / side * 7) * 0.04 + 0.05 + random.NextDouble() * 0.001;
                uint shade = (uint)(110 + height * 1000);
                int at = i * s_bits.Length;
                records[at] = (uint)math.min(x * step, (1 << PositionBits) - 1);
                records[at + 1] = (uint)math.min(y * step, (1 << PositionBits) - 1);
                records[at + 2] = (uint)(height * (1 << PositionBits));
                records[at + 3] = shade + random.NextUInt(16);
                records[at + 4] = shade + random.NextUInt(16);
                records[at + 5] = shade / 2 + random.NextUInt(16);
                records[at + 6] = random.NextUInt(4096);
                records[at + 7] = random.NextUInt(64) == 0 ? 1U : 0;
            }
        }

        static int Pack(uint[] records, int count, byte[] packet)
        {
            Array.Clear(packet, 0, packet.Length);
            int bytes = PacketBytes(count);
            packet[0] = 1;
            BitConverter.GetBytes((ushort)(bytes - 1)).CopyTo(packet, 2);
            packet[4] = (byte)s_bits.Length;
            int at = 6 + 2 * s_bits.Length;
            for (int field = 0; field < s_bits.Length; field++)
            {
                int bits = s_bits[field], length = (count * bits + 7) / 8;
                BitConverter.GetBytes((ushort)length).CopyTo(packet, 6 + 2 * field);
                ulong register = 0;
                int held = 0, to = at;
                for (int i = 0; i < count; i++)
                {
                    register |= (ulong)records[i * s_bits.Length + field] << held;
                    for (held += bits; held >= 8; held -= 8, register >>= 8)
                        packet[to++] = (byte)register;
                }
                if (held > 0)
                    packet[to] = (byte)register;
                at += length;
            }
            return bytes;
        }

        static string Xml(long points)
        {
            string Scaled(string name) => "<" + name + " type=\"ScaledInteger\" minimum=\"0\" maximum=\"" +
                ((1 << PositionBits) - 1) + "\" scale=\"0.0005\" offset=\"0\"/>\n";
            string Plain(string name, int maximum) =>
                "<" + name + " type=\"Integer\" minimum=\"0\" maximum=\"" + maximum + "\"/>\n";
            return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<e57Root type=\"Structure\" " +
                "xmlns=\"http://www.astm.org/COMMIT/E57/2010-e57-v1.0\">\n" +
                "<formatName type=\"String\">ASTM E57 3D Imaging Data File</formatName>\n<guid type=\"String\">hills</guid>\n" +
                "<versionMajor type=\"Integer\">1</versionMajor>\n<versionMinor type=\"Integer\">0</versionMinor>\n" +
                "<data3D type=\"Vector\" allowHeterogeneousChildren=\"1\">\n<vectorChild type=\"Structure\">\n" +
                "<guid type=\"String\">hills 1</guid>\n<name type=\"String\">hills</name>\n" +
                "<points type=\"CompressedVector\" fileOffset=\"" + HeaderBytes + "\" recordCount=\"" + points +
                "\">\n<prototype type=\"Structure\">\n" + Scaled("cartesianX") +
                Scaled("cartesianY") + Scaled("cartesianZ") + Plain("colorRed", 255) + Plain("colorGreen", 255) +
                Plain("colorBlue", 255) + Plain("intensity", 4095) + Plain("cartesianInvalidState", 1) +
                "</prototype>\n<codecs type=\"Vector\" allowHeterogeneousChildren=\"1\"/>\n</points>\n</vectorChild>\n" +
                "</data3D>\n</e57Root>\n";
        }
    }
}
