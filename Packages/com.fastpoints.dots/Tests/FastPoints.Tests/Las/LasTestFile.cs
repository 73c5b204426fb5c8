using System;
using System.Collections.Generic;
using System.IO;
using System.Text;

namespace FastPoints.Tests.Las
{
    /// <summary>A LAS file put together byte by byte from the specification, without the package's own tables.</summary>
    sealed class LasTestFile : TemporaryFile
    {
        public static readonly int[] HeaderBytesOfMinor = { 227, 227, 227, 235, 375, 393 };
        public static readonly int[] RecordBytesOfFormat = { 20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67 };

        sealed class Record
        {
            public string User;
            public int Id;
            public byte[] Data;
        }

        public static byte[] Shorts(params int[] values)
        {
            var bytes = new byte[2 * values.Length];
            for (int i = 0; i < values.Length; i++)
                BitConverter.GetBytes((ushort)values[i]).CopyTo(bytes, 2 * i);
            return bytes;
        }

        readonly List<Record> m_vlrs = new List<Record>();
        readonly List<Record> m_evlrs = new List<Record>();

        public int Minor = 2;
        public int Format;
        public int ExtraBytes;
        public byte[] Points = new byte[0];
        public double[] Scale = { 0.01, 0.01, 0.01 };
        public double[] Offset = { 0, 0, 0 };
        public double[] Min = { 0, 0, 0 };
        public double[] Max = { 1000, 1000, 1000 };
        public int Padding;
        public int GlobalEncoding;
        public int TimeOffset;

        public LasTestFile() : base(".las") { }

        public int RecordBytes => RecordBytesOfFormat[Format] + ExtraBytes;
        public int Count => Points.Length / RecordBytes;

        public int PointsOffset
        {
            get
            {
                int end = HeaderBytesOfMinor[Minor] + Padding;
                foreach (var vlr in m_vlrs)
                    end += 54 + vlr.Data.Length;
                return end;
            }
        }

        public LasTestFile Vlr(string user, int id, byte[] data)
        {
            m_vlrs.Add(new Record { User = user, Id = id, Data = data });
            return this;
        }

        public LasTestFile Evlr(string user, int id, byte[] data)
        {
            m_evlrs.Add(new Record { User = user, Id = id, Data = data });
            return this;
        }

        public LasTestFile RandomPoints(int count, int seed = 1)
        {
            var random = new Random(seed);
            Points = new byte[count * RecordBytes];
            random.NextBytes(Points);
            for (int i = 0; i < count; i++)
                for (int axis = 0; axis < 3; axis++)
                    BitConverter.GetBytes(random.Next(0, 100000)).CopyTo(Points, i * RecordBytes + 4 * axis);
            return this;
        }

        public LasTestFile Positions(params int[] xyz)
        {
            Points = new byte[xyz.Length / 3 * RecordBytes];
            for (int i = 0; i < xyz.Length; i++)
                BitConverter.GetBytes(xyz[i]).CopyTo(Points, i / 3 * RecordBytes + i % 3 * 4);
            return this;
        }

        public byte[] ToBytes()
        {
            var header = new byte[HeaderBytesOfMinor[Minor]];
            Encoding.ASCII.GetBytes("LASF").CopyTo(header, 0);
            BitConverter.GetBytes((ushort)GlobalEncoding).CopyTo(header, 6);
            header[24] = 1;
            header[25] = (byte)Minor;
            Encoding.ASCII.GetBytes("test system").CopyTo(header, 26);
            Encoding.ASCII.GetBytes("test software").CopyTo(header, 58);
            BitConverter.GetBytes((ushort)36).CopyTo(header, 90);
            BitConverter.GetBytes((ushort)2024).CopyTo(header, 92);
            BitConverter.GetBytes((ushort)header.Length).CopyTo(header, 94);
            BitConverter.GetBytes(PointsOffset).CopyTo(header, 96);
            BitConverter.GetBytes(m_vlrs.Count).CopyTo(header, 100);
            header[104] = (byte)Format;
            BitConverter.GetBytes((ushort)RecordBytes).CopyTo(header, 105);
            if (Format < 6)
                BitConverter.GetBytes(Count).CopyTo(header, 107);
            for (int axis = 0; axis < 3; axis++)
            {
                BitConverter.GetBytes(Scale[axis]).CopyTo(header, 131 + 8 * axis);
                BitConverter.GetBytes(Offset[axis]).CopyTo(header, 155 + 8 * axis);
                BitConverter.GetBytes(Max[axis]).CopyTo(header, 179 + 16 * axis);
                BitConverter.GetBytes(Min[axis]).CopyTo(header, 187 + 16 * axis);
            }
            if (Minor >= 5)
                BitConverter.GetBytes((ushort)TimeOffset).CopyTo(header, 391);
            if (Minor >= 4)
            {
                if (m_evlrs.Count > 0)
                    BitConverter.GetBytes((long)PointsOffset + Points.Length).CopyTo(header, 235);
                BitConverter.GetBytes(m_evlrs.Count).CopyTo(header, 243);
                BitConverter.GetBytes((long)Count).CopyTo(header, 247);
            }

            var file = new MemoryStream();
            file.Write(header, 0, header.Length);
            foreach (var vlr in m_vlrs)
                Put(file, vlr, BitConverter.GetBytes((ushort)vlr.Data.Length));
            file.Write(new byte[Padding], 0, Padding);
            file.Write(Points, 0, Points.Length);
            foreach (var evlr in m_evlrs)
                Put(file, evlr, BitConverter.GetBytes((long)evlr.Data.Length));
            return file.ToArray();
        }

        public LasTestFile Save() => Save(ToBytes());

        public LasTestFile Save(byte[] bytes)
        {
            File.WriteAllBytes(Path, bytes);
            return this;
        }

        public LasTestFile SaveWith(int at, byte[] field)
        {
            var bytes = ToBytes();
            field.CopyTo(bytes, at);
            return Save(bytes);
        }

        static void Put(Stream file, Record record, byte[] length)
        {
            var header = new byte[20 + length.Length + 32];
            Encoding.ASCII.GetBytes(record.User).CopyTo(header, 2);
            BitConverter.GetBytes((ushort)record.Id).CopyTo(header, 18);
            length.CopyTo(header, 20);
            Encoding.ASCII.GetBytes("a description").CopyTo(header, 20 + length.Length);
            file.Write(header, 0, header.Length);
            file.Write(record.Data, 0, record.Data.Length);
        }
    }
}
