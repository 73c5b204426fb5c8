using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Base;
using FastPoints.Files;
using FastPoints.Points;

namespace FastPoints.Tests.Files
{
    /// <summary>Everything that a reader gives of an E57 file, read block by block.</summary>
    sealed class E57Contents
    {
        readonly Dictionary<string, Array> m_columns = new Dictionary<string, Array>();

        public SourceInfo Info;
        public long Points;
        public long PointsInBlocks;
        public int Blocks;

        /// <summary>Reads the attributes of these names, or all where none are named.</summary>
        public static E57Contents Read(byte[] file, params string[] names)
        {
            using var path = new E57TestFile(file);
            return Read(path.Path, names);
        }

        public static E57Contents Read(string path, params string[] names)
        {
            using var reader = PointReaders.Open(path);
            WorkPump.RunToEnd(reader.FindBlocks());
            var wanted = names.Length == 0 ? reader.Info.Schema : reader.Info.Schema.Select(names);
            var contents = new E57Contents { Info = reader.Info, Blocks = reader.BlockCount, PointsInBlocks = reader.PointCount };
            var bytes = new MemoryStream[wanted.Count];
            for (int i = 0; i < bytes.Length; i++)
                bytes[i] = new MemoryStream();
            if (reader.BlockCount > 0)
                contents.Points = ReadPoints.EachBlock(reader, wanted, read =>
                {
                    for (int i = 0; i < bytes.Length; i++)
                    {
                        int count = read.Points.Count * wanted[i].Type.SizeOf();
                        var column = read.Points.Bytes.GetSubArray(read.Points.Column(i).OffsetBytes, count);
                        bytes[i].Write(column.ToArray(), 0, count);
                    }
                });
            for (int i = 0; i < bytes.Length; i++)
                contents.m_columns.Add(wanted[i].Name, bytes[i].ToArray());
            return contents;
        }

        public byte[] Bytes(string name) => (byte[])m_columns[name];

        public T[] Column<T>(string name) where T : unmanaged
        {
            byte[] bytes = Bytes(name);
            var values = new T[Points];
            Buffer.BlockCopy(bytes, 0, values, 0, bytes.Length);
            return values;
        }

        public AttributeType TypeOf(string name) => Info.Schema[Info.Schema.IndexOf(name)].Type;

        public bool HasWarning(string part) => Info.Warnings.Exists(warning => warning.Text.Contains(part));

        public bool HasFact(string part) => Info.Facts.Exists(fact => (fact.Key + ": " + fact.Value).Contains(part));
    }
}
