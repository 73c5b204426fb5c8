using System.Collections.Generic;
using FastPoints.Sources;
using FastPoints.Store;
using FastPoints.Streaming;
using FastPoints.Tests.Reading;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Tests.Streaming
{
    /// <summary>Points as sorted hashes: those that a stream draws, and those of the source itself.</summary>
    static unsafe class StreamedPoints
    {
        /// <summary>Unpacked from where the last frame would be drawn from.</summary>
        public static ulong[] Drawn(StreamContext stream, int number)
        {
            var cloud = stream.Clouds[number];
            var hashes = new List<ulong>();
            var values = new ulong[16][];
            foreach (var drawn in stream.Drawn.AsArray().ToArray())
            {
                if (drawn.Cloud != number)
                    continue;
                int blocks = cloud.Pages[drawn.Page].Nodes[drawn.Node].BlockCount;
                var corner = cloud.Source.Root.Corner + cloud.Pages[drawn.Page].Addresses[drawn.Node].Corner;
                for (int block = 0; block < blocks; block++)
                {
                    byte* at = ((MemoryNodePool)stream.Pool).AddressOf(drawn.Range);
                    int columns = 0, points = 0;
                    for (int p = 0; p < cloud.Source.Planes.Length; p++)
                    {
                        var plane = new PlaneView(at, cloud.ShapeOf(drawn.Page, drawn.Node, p), blocks);
                        at += cloud.RangeOf(drawn.Page, drawn.Node, p).LengthBytes;
                        points = plane.PointsOf(block);
                        for (int c = 0; c < plane.Shape.ColumnCount; c++, columns++)
                        {
                            values[columns] = new ulong[PlaneShape.MaxPointsPerBlock];
                            for (int i = 0; i < points; i++)
                                values[columns][i] = plane.ValueAt(block, c, i);
                        }
                    }
                    for (int i = 0; i < points; i++)
                    {
                        ulong hash = Hash(1, (ulong)((long)values[0][i] + corner.X));
                        hash = Hash(hash, (ulong)((long)values[1][i] + corner.Y));
                        hash = Hash(hash, (ulong)((long)values[2][i] + corner.Z));
                        for (int c = 3; c < columns; c++)
                            hash = Hash(hash, values[c][i]);
                        hashes.Add(hash);
                    }
                }
            }
            hashes.Sort();
            return hashes.ToArray();
        }

        public static ulong[] Of(string path, CloudGrid grid, params string[] names)
        {
            var hashes = new List<ulong>();
            using (var reader = PointReaders.Open(path))
            {
                JobCoroutine.RunToEnd(reader.IndexBlocks());
                ReadPoints.EachBlock(reader, reader.Info.Schema,
                    read => AddAll(hashes, read.Points, reader.Info.Transform, grid, names));
            }
            hashes.Sort();
            return hashes.ToArray();
        }

        public static ulong[] Of(PointBatch points, PositionTransform transform, CloudGrid grid, params string[] names)
        {
            var hashes = new List<ulong>();
            AddAll(hashes, points, transform, grid, names);
            hashes.Sort();
            return hashes.ToArray();
        }

        static void AddAll(List<ulong> hashes, PointBatch points, PositionTransform transform, CloudGrid grid, string[] names)
        {
            byte* bytes = (byte*)points.Bytes.GetUnsafeReadOnlyPtr();
            var positions = PositionColumns.Of(points);
            for (int i = 0; i < points.Count; i++)
            {
                var geo = positions.GeoAt(bytes, transform, i);
                var position = math.round((geo - grid.Origin) / grid.Step);
                ulong hash = Hash(Hash(Hash(1, (ulong)(long)position.x), (ulong)(long)position.y), (ulong)(long)position.z);
                foreach (string name in names)
                {
                    var column = points.Column(points.Schema.IndexOf(name));
                    byte* value = bytes + column.OffsetBytes + i * column.Type.SizeOf();
                    hash = Hash(hash, OrderedBits.Load(value, column.Type));
                }
                hashes.Add(hash);
            }
        }

        static ulong Hash(ulong hash, ulong value) => (hash ^ value) * 0x9E3779B97F4A7C15UL ^ hash >> 29;
    }
}
