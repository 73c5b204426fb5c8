using System;
using System.Linq;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Tests.Nodes
{
    public sealed class MemoryReader : PointReader
    {
        readonly int m_points, m_blockPoints;
        readonly Array[] m_columns;

        public MemoryReader(PointSchema schema, PositionTransform transform, int blockPoints, params Array[] columns)
        {
            m_columns = columns;
            m_points = columns[0].Length;
            m_blockPoints = blockPoints;
            Info = new SourceInfo
            {
                Path = "memory",
                Format = "memory",
                Schema = schema,
                Transform = transform,
                PointsReadable = m_points
            };
        }

        public static MemoryReader Of(int3[] positions, PositionTransform transform, int blockPoints = 1000, uint seed = 1)
        {
            int count = positions.Length;
            int[] x = new int[count], y = new int[count], z = new int[count];
            ushort[] intensity = new ushort[count], red = new ushort[count], green = new ushort[count], blue = new ushort[count];
            var random = new Unity.Mathematics.Random(seed);
            for (int i = 0; i < count; i++)
            {
                x[i] = positions[i].x;
                y[i] = positions[i].y;
                z[i] = positions[i].z;
                intensity[i] = (ushort)random.NextInt(65536);
                red[i] = (ushort)(random.NextInt(256) * 257);
                green[i] = (ushort)(random.NextInt(256) * 256);
                blue[i] = (ushort)random.NextInt(65536);
            }
            var attributes = PositionColumns.Attributes(AttributeType.Int32)
                .Append(new PointAttribute(AttributeNames.Intensity, AttributeType.UInt16))
                .Concat(TestBatches.Colors(AttributeType.UInt16));
            return new MemoryReader(new PointSchema(attributes), transform, blockPoints, x, y, z, intensity, red, green, blue);
        }

        public ulong Filter { get; set; }

        internal override ulong FilterHash => Filter;
        public override int BlockCount => (m_points + m_blockPoints - 1) / m_blockPoints;
        public override int MaxPointsPerBlock => Math.Min(m_blockPoints, m_points);
        public override bool HasCheapRanges => true;

        public override long FirstPointOfBlock(int block) => (long)block * m_blockPoints;

        public override int PointsInBlock(int block) => Math.Min(m_blockPoints, m_points - block * m_blockPoints);

        public override long BytesOfRange(BlockRange range) => (long)range.Count * Info.Schema.BytesPerPoint;

        public int BlocksWithoutDependency { get; private set; }
        public long SlotBytes { get; private set; }
        public long MaxSlotBytes { get; private set; }

        public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator)
        {
            SlotBytes += BytesOfSlot(wanted);
            MaxSlotBytes = Math.Max(MaxSlotBytes, SlotBytes);
            return new Slot(this, wanted, capacity, allocator);
        }

        long BytesOfSlot(PointSchema wanted) =>
            (long)MaxPointsPerBlock * (wanted.BytesPerPoint + Info.Schema.BytesPerPoint);

        sealed class Slot : ImmediateRead
        {
            readonly MemoryReader m_reader;

            public Slot(MemoryReader reader, PointSchema wanted, int capacity, Allocator allocator)
                : base(reader, wanted, capacity, allocator) => m_reader = reader;

            protected override void Fill(BlockRange range, NativeArray<byte> bytes)
            {
                m_reader.BlocksWithoutDependency += Dependency.Equals(default) ? 1 : 0;
                for (int c = 0; c < Points.Schema.Count; c++)
                {
                    int size = Points.Schema[c].Type.SizeOf();
                    var raw = new byte[range.Count * size];
                    Buffer.BlockCopy(m_reader.m_columns[m_reader.Info.Schema.IndexOf(Points.Schema[c].Name)],
                        (int)FirstPoint * size, raw, 0, raw.Length);
                    NativeArray<byte>.Copy(raw, 0, bytes, Points.Column(c).OffsetBytes, raw.Length);
                }
            }

            public override void Dispose()
            {
                if (Result.IsCreated)
                    m_reader.SlotBytes -= m_reader.BytesOfSlot(Points.Schema);
                base.Dispose();
            }
        }
    }
}
