using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.E57
{
    [BurstCompile]
    unsafe struct DecodeE57Job : IJob
    {
        public const int FieldsPerSlice = 16;
        const int TileValues = 256;

        [ReadOnly] public NativeArray<byte> Input;
        [ReadOnly] public NativeArray<byte> IsDamaged;
        [ReadOnly] public NativeArray<E57Extent> Extents;
        public int ExtentCount;
        public int StreamCount;
        [ReadOnly] public NativeArray<E57FieldRead> Reads;
        [ReadOnly] public NativeArray<E57StreamRange> Ranges;
        public int FirstRead;
        public int ReadCount;

        public long FirstRecord;
        public int Count;
        public NativeArray<byte> Columns;

        // Rows of RowLength doubles.
        public NativeArray<double> Vectors;
        public int RowLength;
        public NativeArray<byte> Rejections; // For each point, 0 or an E57Rejection.

        public NativeArray<byte> Scratch;
        public NativeReference<DecodeResult> Result;
        public NativeReference<E57Anomalies> Anomalies;

        public void Execute()
        {
            var result = FirstRead == 0 ? new DecodeResult { Points = Count } : Result.Value;
            var anomalies = FirstRead == 0 ? default : Anomalies.Value;
            byte* rejections = (byte*)Rejections.GetUnsafePtr();
            if (FirstRead == 0)
                UnsafeUtility.MemClear(rejections, Count);
            for (int i = FirstRead; i < FirstRead + ReadCount; i++)
            {
                var read = Reads[i];
                int there = read.Stream < 0 || read.Bits == 0 ? Count : Gather(read, Ranges[i], rejections);
                if (there < result.Points)
                {
                    result.Points = there;
                    result.Error = E57Error.FileChanged;
                    result.ErrorOffset = E57Pages.ToPhysical(Ranges[i].PacketOffset);
                }
                anomalies.Clamped += Decode(read, there, rejections);
            }
            Result.Value = result;
            Anomalies.Value = anomalies;
        }

        int Gather(in E57FieldRead read, in E57StreamRange range, byte* rejections)
        {
            byte* input = (byte*)Input.GetUnsafeReadOnlyPtr();
            byte* scratch = (byte*)Scratch.GetUnsafePtr();
            long firstBit = FirstRecord * read.Bits;
            long first = firstBit >> 3, end = first + E57Bits.BytesOf(firstBit, read.Bits, Count);
            int at = 0;
            while (at < ExtentCount && Extents[at].LogicalEnd <= range.PacketOffset)
                at++;
            if (at == ExtentCount || Extents[at].LogicalStart > range.PacketOffset)
                return 0;
            var extent = Extents[at];
            long stop = math.min(range.End, extent.LogicalEnd), position = range.PacketOffset, before = range.BytesBefore;
            while (before < end && position < stop)
            {
                byte* packet = input + extent.ToBuffer + position;
                int error = E57Packet.Read(packet, stop - position, stop - position, StreamCount, out var header, out _);
                if (error != E57Error.None)
                    break;
                if (header.Kind == E57Packet.DataKind)
                {
                    long inPacket = header.HeaderBytes;
                    for (int i = 0; i < read.Stream; i++)
                        inPacket += E57Packet.StreamBytes(packet, i);
                    int bytes = E57Packet.StreamBytes(packet, read.Stream);
                    long from = math.max(first, before), to = math.min(end, before + bytes);
                    if (from < to)
                    {
                        long logical = position + inPacket + (from - before);
                        UnsafeUtility.MemCpy(scratch + (from - first), input + extent.ToBuffer + logical, to - from);
                        MarkDamage(extent, logical, from, (int)(to - from), read.Bits, rejections);
                    }
                    before += bytes;
                }
                position += header.Bytes;
            }
            if (before >= end)
                return Count;
            long whole = (before * 8 - firstBit) / read.Bits;
            return (int)math.clamp(whole, 0, Count);
        }

        // Points with bits in damaged pages are left out. inStream: the offset of the bytes in the bytestream.
        void MarkDamage(in E57Extent extent, long logical, long inStream, int bytes, int bits, byte* rejections)
        {
            long firstPage = logical / E57Pages.DataBytes, lastPage = (logical + bytes - 1) / E57Pages.DataBytes;
            for (long page = firstPage; page <= lastPage; page++)
            {
                if (IsDamaged[(int)(page - extent.FirstPage) + extent.BufferPage] == 0)
                    continue;
                long from = math.max(logical, page * E57Pages.DataBytes) - logical + inStream;
                long to = math.min(logical + bytes, (page + 1) * E57Pages.DataBytes) - logical + inStream;
                long first = math.max(from * 8 / bits - FirstRecord, 0);
                long end = math.min((to * 8 + bits - 1) / bits - FirstRecord, Count);
                for (long i = first; i < end; i++)
                    rejections[i] = E57Rejection.Damaged;
            }
        }

        int Decode(in E57FieldRead read, int count, byte* rejections)
        {
            ulong* raw = stackalloc ulong[TileValues];
            double* reals = stackalloc double[TileValues];
            byte* scratch = (byte*)Scratch.GetUnsafePtr();
            byte* columns = (byte*)Columns.GetUnsafePtr();
            double* vectors = (double*)Vectors.GetUnsafePtr();
            if (IsCopy(read))
            {
                int bytes = read.Bits / 8;
                UnsafeUtility.MemCpy(columns + read.ColumnOffsetBytes, scratch, (long)count * bytes);
                return 0;
            }
            long firstBit = FirstRecord * read.Bits & 7;
            bool canExceed = read.Range != E57Bits.Mask(read.Bits);
            long minimum = read.Kind == E57FieldKind.Integer ? read.Minimum : 0;
            int clamped = 0;
            for (int first = 0; first < count; first += TileValues)
            {
                int tile = math.min(TileValues, count - first);
                if (read.Bits == 0)
                    UnsafeUtility.MemClear(raw, tile * 8);
                else
                    E57Bits.Unpack(scratch, firstBit + (long)first * read.Bits, read.Bits, tile, raw);
                if (read.Kind == E57FieldKind.Integer && canExceed)
                    clamped += Clamp(raw, tile, read.Range);
                if (read.Target == E57Target.Integers)
                {
                    if (read.Factor != 1)
                        Multiply((long*)raw, tile, read.Factor);
                    StoreIntegers((long*)raw, tile, minimum * read.Factor + read.Shift, columns + read.ColumnOffsetBytes,
                        read.ColumnType, first);
                    continue;
                }
                if (read.Target == E57Target.InvalidFlag && read.Kind == E57FieldKind.Integer)
                {
                    for (int i = 0; i < tile; i++)
                        if ((long)raw[i] + minimum != 0 && rejections[first + i] == 0)
                            rejections[first + i] = E57Rejection.Invalid;
                    continue;
                }
                ToReals(raw, tile, read, reals);
                switch (read.Target)
                {
                    case E57Target.Vector:
                        UnsafeUtility.MemCpy(vectors + (long)read.Row * RowLength + first, reals, tile * 8);
                        break;
                    case E57Target.InvalidFlag:
                        for (int i = 0; i < tile; i++)
                            if (reals[i] != 0 && rejections[first + i] == 0)
                                rejections[first + i] = E57Rejection.Invalid;
                        break;
                    case E57Target.To16Bits:
                        StoreRounded16(reals, tile, (ushort*)(columns + read.ColumnOffsetBytes) + first);
                        break;
                    default:
                        StoreReals(reals, tile, columns + read.ColumnOffsetBytes, read.ColumnType, first);
                        break;
                }
            }
            return clamped;
        }

        static bool IsCopy(in E57FieldRead read)
        {
            if (read.Bits != read.ColumnType.SizeOf() * 8)
                return false;
            if (read.Kind == E57FieldKind.Integer)
                return read.Target == E57Target.Integers && read.Factor == 1 && read.Minimum + read.Shift == 0
                    && read.Range == E57Bits.Mask(read.Bits);
            return read.Target == E57Target.Reals && read.Scale == 1 && read.Offset == 0;
        }

        static int Clamp(ulong* raw, int count, ulong range)
        {
            int clamped = 0;
            for (int i = 0; i < count; i++)
            {
                ulong value = raw[i];
                clamped += value > range ? 1 : 0;
                raw[i] = math.min(value, range);
            }
            return clamped;
        }

        static void ToReals(ulong* raw, int count, in E57FieldRead read, double* reals)
        {
            double factor = read.Scale, addend = read.Offset;
            if (read.Kind == E57FieldKind.Integer)
            {
                for (int i = 0; i < count; i++)
                    reals[i] = ((long)raw[i] + read.Minimum) * factor + addend;
                return;
            }
            if (read.Kind == E57FieldKind.Float32)
                for (int i = 0; i < count; i++)
                    reals[i] = math.asfloat((uint)raw[i]);
            else
                for (int i = 0; i < count; i++)
                    reals[i] = math.asdouble(raw[i]);
            if (factor == 1 && addend == 0)
                return;
            for (int i = 0; i < count; i++)
                reals[i] = reals[i] * factor + addend;
        }

        static void Multiply(long* values, int count, long factor)
        {
            for (int i = 0; i < count; i++)
                values[i] *= factor;
        }

        static void StoreIntegers(long* values, int count, long bias, byte* column, AttributeType type, int first)
        {
            switch (type)
            {
                case AttributeType.UInt8:
                case AttributeType.Int8:
                    for (int i = 0; i < count; i++)
                        column[first + i] = (byte)(values[i] + bias);
                    break;
                case AttributeType.UInt16:
                case AttributeType.Int16:
                    for (int i = 0; i < count; i++)
                        ((ushort*)column)[first + i] = (ushort)(values[i] + bias);
                    break;
                case AttributeType.UInt32:
                case AttributeType.Int32:
                    for (int i = 0; i < count; i++)
                        ((uint*)column)[first + i] = (uint)(values[i] + bias);
                    break;
                default:
                    for (int i = 0; i < count; i++)
                        ((long*)column)[first + i] = values[i] + bias;
                    break;
            }
        }

        static void StoreReals(double* values, int count, byte* column, AttributeType type, int first)
        {
            if (type == AttributeType.Float32)
                for (int i = 0; i < count; i++)
                    ((float*)column)[first + i] = (float)values[i];
            else
                UnsafeUtility.MemCpy((double*)column + first, values, count * 8);
        }

        // NaN becomes 0.
        static void StoreRounded16(double* values, int count, ushort* column)
        {
            for (int i = 0; i < count; i++)
                column[i] = (ushort)(values[i] > 0 ? math.min(values[i] + 0.5, ushort.MaxValue) : 0);
        }
    }

    static class E57Rejection
    {
        public const byte Invalid = 1;
        public const byte Damaged = 2;
    }

    struct E57Anomalies
    {
        public int Invalid;
        public int Damaged;
        public int DamagedPages;
        public long FirstDamagedPage;
        public int Clamped;
    }

    struct E57StreamRange
    {
        public long PacketOffset; // Logical, of a packet at or before the first byte.
        public long BytesBefore; // In the packets before it.
        public long End; // Logical, where the packets that are read end.
    }

    // Integers of any width, packed without gaps from the lowest bit of the first byte on (ASTM E2807, 9.7.2): value i takes bits
    // i*w to i*w + w - 1, where bit b is bit b % 8 of byte b / 8.
    static unsafe class E57Bits
    {
        public const int PaddingBytes = 16; // After the last value: loaded by wide reads, never used.

        public static ulong Mask(int bits) => bits == 0 ? 0 : ulong.MaxValue >> 64 - bits;

        // bits: 1 to 64.
        public static void Unpack(byte* bytes, long firstBit, int bits, int count, ulong* values)
        {
            ulong mask = Mask(bits);
            if ((firstBit & 7) == 0 && (bits == 8 || bits == 16 || bits == 32))
            {
                UnpackBytes(bytes + (firstBit >> 3), bits, count, values);
                return;
            }
            if (bits <= 57)
            {
                long at = firstBit;
                for (int i = 0; i < count; i++, at += bits)
                    values[i] = *(ulong*)(bytes + (at >> 3)) >> (int)(at & 7) & mask;
                return;
            }
            for (int i = 0; i < count; i++)
            {
                long at = firstBit + (long)i * bits;
                int shift = (int)(at & 7);
                byte* p = bytes + (at >> 3);
                ulong value = *(ulong*)p >> shift;
                // This shifts twice, since a shift by 64 is one by 0.
                value |= (ulong)p[8] << (63 - shift) << 1;
                values[i] = value & mask;
            }
        }

        static void UnpackBytes(byte* bytes, int bits, int count, ulong* values)
        {
            if (bits == 8)
                for (int i = 0; i < count; i++)
                    values[i] = bytes[i];
            else if (bits == 16)
                for (int i = 0; i < count; i++)
                    values[i] = ((ushort*)bytes)[i];
            else
                for (int i = 0; i < count; i++)
                    values[i] = ((uint*)bytes)[i];
        }

        public static long BytesOf(long firstBit, int bits, long count) => (firstBit + count * bits + 7 >> 3) - (firstBit >> 3);
    }
}
