using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Base;
using FastPoints.Files;
using FastPoints.Points;
using Unity.Collections;

namespace FastPoints.Tests.Files
{
    /// <summary>Everything that a reader gives of a file, read block by block.</summary>
    sealed class PlyContents
    {
        readonly Dictionary<string, MemoryStream> m_bytesOfName = new Dictionary<string, MemoryStream>();

        public SourceInfo Info;
        public int Points;
        public int Blocks;

        /// <summary>Reads the attributes of these names, or all where none are named.</summary>
        public static PlyContents Read(string path, params string[] names)
        {
            using var reader = PlyReader.Open(path);
            WorkPump.RunToEnd(reader.FindBlocks());
            var wanted = names.Length == 0 ? reader.Info.Schema : reader.Info.Schema.Select(names);
            var contents = new PlyContents { Info = reader.Info, Blocks = reader.BlockCount };
            foreach (var attribute in wanted)
                contents.m_bytesOfName.Add(attribute.Name, new MemoryStream());
            if (reader.BlockCount == 0)
                return contents;
            using (var read = reader.CreateRead(wanted, reader.MaxPointsPerBlock, Allocator.Persistent))
                for (int block = 0; block < reader.BlockCount; block++)
                {
                    read.Begin(new BlockRange(block, 0, reader.PointsInBlock(block)));
                    read.Complete();
                    contents.Take(read.Points);
                }
            return contents;
        }

        public void Take(PointBatch batch)
        {
            Points += batch.Count;
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

        public bool HasWarning(string part) => WarningAt(part) != null;

        public CloudWarning? WarningAt(string part)
        {
            foreach (var warning in Info.Warnings)
                if (warning.Text.Contains(part))
                    return warning;
            return null;
        }
    }
}
