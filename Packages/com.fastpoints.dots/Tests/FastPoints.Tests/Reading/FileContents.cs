using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using FastPoints.Reading;
using FastPoints.Sources;

namespace FastPoints.Tests.Reading
{
    sealed class FileContents
    {
        readonly Dictionary<string, MemoryStream> m_bytesOfName = new Dictionary<string, MemoryStream>();

        public SourceInfo Info;
        public long Points;
        public long PointsInBlocks;
        public int Blocks;

        public static FileContents OfPly(string path, params string[] names) => Read(PointReaders.Open(path), names);

        public static FileContents OfE57(string path, params string[] names) => Read(PointReaders.Open(path), names);

        public static FileContents OfE57(byte[] bytes, params string[] names)
        {
            using var file = new TemporaryFile(bytes, ".e57");
            return OfE57(file.Path, names);
        }

        static FileContents Read(PointReader opened, string[] names)
        {
            using var reader = opened;
            JobCoroutine.RunToEnd(reader.IndexBlocks());
            var wanted = names.Length == 0 ? reader.Info.Schema : reader.Info.Schema.Select(names);
            var contents = new FileContents { Info = reader.Info, Blocks = reader.BlockCount };
            contents.PointsInBlocks = reader.PointCount;
            foreach (var attribute in wanted)
                contents.m_bytesOfName.Add(attribute.Name, new MemoryStream());
            if (reader.BlockCount > 0)
                contents.Points = ReadPoints.EachBlock(reader, wanted, read => contents.Take(read.Points));
            return contents;
        }

        void Take(PointBatch batch)
        {
            for (int i = 0; i < batch.Schema.Count; i++)
            {
                int bytes = batch.Count * batch.Schema[i].Type.SizeOf();
                byte[] column = batch.Bytes.GetSubArray(batch.Column(i).OffsetBytes, bytes).ToArray();
                m_bytesOfName[batch.Schema[i].Name].Write(column, 0, bytes);
            }
        }

        public byte[] Bytes(string name) => m_bytesOfName[name].ToArray();

        public T[] Column<T>(string name) where T : unmanaged
        {
            byte[] bytes = Bytes(name);
            var values = new T[Points];
            Buffer.BlockCopy(bytes, 0, values, 0, bytes.Length);
            return values;
        }

        public AttributeType TypeOf(string name) => Info.Schema[Info.Schema.IndexOf(name)].Type;

        public bool HasWarning(string part) => Info.Warnings.Exists(warning => warning.Text.Contains(part));

        public CloudWarning Warning(string part) => Info.Warnings.First(warning => warning.Text.Contains(part));

        public bool HasFact(string part) => Info.Facts.Exists(fact => (fact.Key + ": " + fact.Value).Contains(part));
    }
}
