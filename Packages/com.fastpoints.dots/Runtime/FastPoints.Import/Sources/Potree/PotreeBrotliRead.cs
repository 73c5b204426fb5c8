using System;
using System.Collections.Generic;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Sources
{
    // Encoding BROTLI of Potree 2: one stream of all values of the first attribute, then all of the second, and so on. It is
    // decompressed and spread over the columns piece by piece, as far as the last wanted attribute.
    sealed class PotreeBrotliRead : NodeRead
    {
        const int BufferBytes = 256 << 10; // About a millisecond of Brotli.

        struct EncodedAttribute
        {
            public int BytesPerPoint;
            public PotreeAttributeKind Kind;

            // In m_copies; a skipped attribute has none.
            public int FirstCopy;
            public int CopyCount;
            public bool IsWanted;
        }

        readonly List<EncodedAttribute> m_encoded = new List<EncodedAttribute>();
        readonly PotreeSpecialColumns m_special;
        readonly DecompressorHandle m_decompressor;
        readonly NativeArray<FieldCopy> m_copies;
        readonly NativeArray<byte> m_buffer;
        readonly NativeReference<DecompressState> m_state;

        public PotreeBrotliRead(PotreeReader reader, PointSchema wanted, int capacity, Allocator allocator)
            : base(reader, wanted, capacity, allocator)
        {
            m_special = PotreeSpecialColumns.Of(reader.Layout, Points);
            m_copies = Own(new NativeArray<FieldCopy>(PlanParts(reader.Layout).ToArray(), allocator));
            m_buffer = OwnArray<byte>(BufferBytes, allocator);
            m_state = Own(new NativeReference<DecompressState>(allocator));
            m_decompressor = Own(new DecompressorHandle(Decompressors.Brotli()));
        }

        List<FieldCopy> PlanParts(PotreeLayout layout)
        {
            var copies = new List<FieldCopy>();
            var attributes = layout.Attributes;
            for (int i = 0; i < attributes.Count; i++)
            {
                var attribute = attributes[i];
                var encoded = new EncodedAttribute
                {
                    BytesPerPoint = attribute.Bytes,
                    Kind = attribute.Kind,
                    FirstCopy = copies.Count,
                };
                foreach (var column in Points.Schema)
                    encoded.IsWanted |= layout.AttributeOf(column) == i;
                // Only these two names stand for Morton codes.
                if (attribute.Name == "position")
                    encoded.BytesPerPoint = DecodePotreeAttributeJob.PositionBytes;
                else if (attribute.Name == "rgb" && attribute.Bytes == 6)
                    encoded.BytesPerPoint = DecodePotreeAttributeJob.ColorBytes;
                else if (attribute.Kind == PotreeAttributeKind.Position || attribute.Kind == PotreeAttributeKind.Color)
                    encoded.Kind = PotreeAttributeKind.Plain;
                if (encoded.Kind != PotreeAttributeKind.Position && !attribute.IsPackedNormal)
                    copies.AddRange(layout.PlanCopies(Points, other => other == attribute, attribute.RecordOffset));
                encoded.CopyCount = copies.Count - encoded.FirstCopy;
                m_encoded.Add(encoded);
            }
            int last = m_encoded.FindLastIndex(encoded => encoded.IsWanted);
            m_encoded.RemoveRange(last + 1, m_encoded.Count - last - 1);
            return copies;
        }

        protected override JobHandle Schedule(BlockRange range, in NodeBlock block)
        {
            var decoded = BeginRead(range);
            bool isFirst = true;
            foreach (var encoded in m_encoded)
            {
                int bufferPoints = Math.Max(1, BufferBytes / encoded.BytesPerPoint);
                for (int first = 0; first < block.Points; first += bufferPoints)
                {
                    int count = Math.Min(bufferPoints, block.Points - first);
                    decoded = new DecompressJob
                    {
                        Input = FileRead.Buffer,
                        InputBytes = BytesRead,
                        Output = m_buffer,
                        Wanted = count * encoded.BytesPerPoint,
                        IsFirst = isFirst,
                        Handle = m_decompressor.Handle,
                        State = m_state,
                    }.Schedule(decoded);
                    isFirst = false;
                    int begin = Math.Max(first, range.First), end = Math.Min(first + count, range.First + range.Count);
                    if (encoded.IsWanted && begin < end)
                        decoded = Spread(encoded, begin - first, begin - range.First, end - begin).Schedule(decoded);
                }
            }
            return new CheckDecompressionJob
            {
                State = m_state,
                Result = Result,
                Points = range.Count,
                Offset = block.Offset,
            }.Schedule(decoded);
        }

        DecodePotreeAttributeJob Spread(EncodedAttribute encoded, int at, int first, int count) => new DecodePotreeAttributeJob
        {
            Buffer = m_buffer,
            Copies = m_copies,
            State = m_state,
            Columns = Points.Bytes,
            Special = m_special,
            Kind = encoded.Kind,
            BytesPerPoint = encoded.BytesPerPoint,
            FirstCopy = encoded.FirstCopy,
            CopyCount = encoded.CopyCount,
            FirstInBuffer = at,
            First = first,
            Count = count,
        };

        protected override void Report(DecodeResult result)
        {
            if (result.Error == PotreeError.None)
                return;
            var failure = m_decompressor.Failure;
            m_decompressor.Failure = null;
            if (failure != null)
                throw new PointCloudException(FailureCode.Unsupported, Reader.Info.Path, result.ErrorOffset,
                    "Brotli cannot be decompressed here (Decompressors.Brotli takes another decompressor): " + failure.Message,
                    failure);
            Reader.WarnBroken(Range.Block, "its Brotli stream is broken: its points are left out", null, result.ErrorOffset);
        }
    }

    // All points or none, since the values of a point are spread over the whole stream.
    [BurstCompile]
    struct CheckDecompressionJob : IJob
    {
        [ReadOnly] public NativeReference<DecompressState> State;
        public NativeReference<DecodeResult> Result;
        public int Points;
        public long Offset;

        public void Execute()
        {
            var state = State.Value;
            Result.Value = state.IsBroken
                ? new DecodeResult { Error = PotreeError.Broken, ErrorOffset = Offset + state.Consumed }
                : new DecodeResult { Points = Points };
        }
    }

    [BurstCompile]
    unsafe struct DecodePotreeAttributeJob : IJob
    {
        public const int PositionBytes = 16; // The upper 16 bits of x, y and z as a Morton code, then the lower 16.
        public const int ColorBytes = 8; // 16 bits of red, green and blue as a Morton code.

        [ReadOnly] public NativeArray<byte> Buffer;
        [ReadOnly] public NativeArray<FieldCopy> Copies;
        [ReadOnly] public NativeReference<DecompressState> State;
        public NativeArray<byte> Columns;
        public PotreeSpecialColumns Special;
        public PotreeAttributeKind Kind;
        public int BytesPerPoint;
        public int FirstCopy;
        public int CopyCount;
        public int FirstInBuffer;
        public int First;
        public int Count;

        public void Execute()
        {
            if (State.Value.IsBroken)
                return;
            byte* from = (byte*)Buffer.GetUnsafeReadOnlyPtr() + (long)FirstInBuffer * BytesPerPoint;
            byte* columns = (byte*)Columns.GetUnsafePtr();
            var copies = new FieldCopies((FieldCopy*)Copies.GetUnsafeReadOnlyPtr() + FirstCopy, CopyCount);
            if (Kind == PotreeAttributeKind.Position)
                DecodePositions((ulong*)from, columns);
            else if (Kind == PotreeAttributeKind.Color)
                DecodeColors((ulong*)from, copies, columns);
            else if (CopyCount > 0)
                PointRecords.ToColumns(from, BytesPerPoint, Count, copies, columns, First);
            else
                Special.DecodeNormals(from, BytesPerPoint, Count, columns, First);
        }

        // PotreeConverter subtracts the node's lowest coordinate, which an overflowing conversion sets to -1 for good: all values
        // are one step too high compared with encoding DEFAULT, so one is subtracted.
        void DecodePositions(ulong* codes, byte* columns)
        {
            var at = Special.PositionOffsets;
            int* x = (int*)(columns + at.x) + First, y = (int*)(columns + at.y) + First, z = (int*)(columns + at.z) + First;
            bool wantsX = at.x >= 0, wantsY = at.y >= 0, wantsZ = at.z >= 0;
            for (int i = 0; i < Count; i++)
            {
                Morton.Decode(codes[2 * i], out uint upperX, out uint upperY, out uint upperZ);
                Morton.Decode(codes[2 * i + 1], out uint lowerX, out uint lowerY, out uint lowerZ);
                if (wantsX)
                    x[i] = (int)((upperX << 16 | lowerX & 0xFFFF) - 1);
                if (wantsY)
                    y[i] = (int)((upperY << 16 | lowerY & 0xFFFF) - 1);
                if (wantsZ)
                    z[i] = (int)((upperZ << 16 | lowerZ & 0xFFFF) - 1);
            }
        }

        // Writes tiles of records, which the plan's copies split into columns.
        void DecodeColors(ulong* codes, FieldCopies copies, byte* columns)
        {
            const int BatchPoints = 256;
            ushort* records = stackalloc ushort[3 * BatchPoints];
            for (int first = 0; first < Count; first += BatchPoints)
            {
                int count = Count - first < BatchPoints ? Count - first : BatchPoints;
                for (int i = 0; i < count; i++)
                {
                    Morton.Decode(codes[first + i], out uint red, out uint green, out uint blue);
                    records[3 * i] = (ushort)red;
                    records[3 * i + 1] = (ushort)green;
                    records[3 * i + 2] = (ushort)blue;
                }
                PointRecords.ToColumns((byte*)records, 6, count, copies, columns, First + first);
            }
        }
    }

    // Columns that are more than a copy; -1 for unwanted ones. Blittable.
    unsafe struct PotreeSpecialColumns
    {
        public int3 PositionOffsets; // First byte of X, Y, Z in the batch.
        public int3 NormalOffsets; // First byte of NormalX, NormalY, NormalZ in the batch, if they are packed in two bytes.

        public int NormalRecordByte;
        public bool IsOctahedral;

        public static PotreeSpecialColumns Of(PotreeLayout layout, PointBatch batch)
        {
            var special = new PotreeSpecialColumns { PositionOffsets = -1, NormalOffsets = -1 };
            foreach (var attribute in layout.Attributes)
            {
                bool isPosition = attribute == layout.Position;
                if (!isPosition && !attribute.IsPackedNormal)
                    continue;
                for (int axis = 0; axis < 3; axis++)
                {
                    int index = batch.Schema.IndexOf(attribute.Columns[axis].Name);
                    if (index >= 0 && isPosition)
                        special.PositionOffsets[axis] = batch.Column(index).OffsetBytes;
                    else if (index >= 0)
                        special.TakeNormal(attribute, axis, batch.Column(index).OffsetBytes);
                }
            }
            return special;
        }

        void TakeNormal(PotreeAttribute attribute, int axis, int column)
        {
            NormalOffsets[axis] = column;
            NormalRecordByte = attribute.RecordOffset;
            IsOctahedral = attribute.Kind == PotreeAttributeKind.OctahedralNormal;
        }

        public void DecodeNormals(byte* from, int stride, int count, byte* columns, int first)
        {
            for (int i = 0; i < count; i++, from += stride)
            {
                var normal = IsOctahedral
                    ? PotreeNormals.FromOctahedron(from[0], from[1]) : PotreeNormals.FromSphereMap(from[0], from[1]);
                for (int axis = 0; axis < 3; axis++)
                    if (NormalOffsets[axis] >= 0)
                        ((float*)(columns + NormalOffsets[axis]))[first + i] = normal[axis];
            }
        }
    }

    internal static class PotreeNormals
    {
        // Pranckevičius, "Compact normal storage for small G-buffers", method 4 (spheremap transform): within 0.02 of what was
        // packed, except for z near -1, where the map has its seam.
        public static float3 FromSphereMap(byte bx, byte by)
        {
            float x = bx * (2f / 255f) - 1, y = by * (2f / 255f) - 1;
            float squared = 1 - x * x - y * y;
            // Writers never pack bytes outside the disc: they become the nearest vector on its rim, which is (0, 0, -1).
            float root = math.sqrt(math.max(0, squared));
            return math.normalizesafe(new float3(2 * x * root, 2 * y * root, 2 * squared - 1), new float3(0, 0, -1));
        }

        // Meyer et al., "On floating-point normal vectors", 2010: octahedral normals.
        public static float3 FromOctahedron(byte bx, byte by)
        {
            float u = bx * (2f / 255f) - 1, v = by * (2f / 255f) - 1;
            float z = 1 - math.abs(u) - math.abs(v);
            float x = u, y = v;
            if (z < 0)
            {
                x = (1 - math.abs(v)) * (u < 0 ? -1 : 1);
                y = (1 - math.abs(u)) * (v < 0 ? -1 : 1);
            }
            return math.normalizesafe(new float3(x, y, z), new float3(0, 0, 1));
        }
    }
}
