using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Files
{
    /// <summary>Records of one length into columns. Every value's bytes are kept, turned round where the file is big
    /// endian.</summary>
    [BurstCompile]
    unsafe struct DecodePlyFixedJob : IJob
    {
        /// <summary>Records that are taken through all copies before the next ones: they stay in the first-level cache.</summary>
        const int TilePoints = 512;

        [ReadOnly] public NativeArray<byte> Input;
        [ReadOnly] public NativeArray<PlyCopy> Copies;
        public int RecordBytes;
        public int Points;
        public bool IsBigEndian;
        [WriteOnly] public NativeArray<byte> Output;
        [WriteOnly] public NativeReference<DecodeResult> Result;

        public void Execute()
        {
            byte* input = (byte*)Input.GetUnsafeReadOnlyPtr();
            byte* output = (byte*)Output.GetUnsafePtr();
            for (int first = 0; first < Points; first += TilePoints)
            {
                int count = math.min(TilePoints, Points - first);
                byte* tile = input + (long)first * RecordBytes;
                for (int i = 0; i < Copies.Length; i++)
                    Copy(tile, output, first, count, Copies[i]);
            }
            Result.Value = new DecodeResult { Points = Points };
        }

        void Copy(byte* tile, byte* output, int first, int count, in PlyCopy copy)
        {
            byte* source = tile + copy.SourceBytes;
            long skip = (long)first * copy.ValueBytes;
            byte* column0 = output + copy.Column0 + skip;
            byte* column1 = output + copy.Column1 + skip;
            byte* column2 = output + copy.Column2 + skip;
            switch (copy.ValueBytes)
            {
                case 1:
                    Copy1(source, column0, column1, column2, copy.Values, count);
                    break;
                case 2:
                    Copy2(source, (ushort*)column0, (ushort*)column1, (ushort*)column2, copy.Values, count);
                    break;
                case 4:
                    Copy4(source, (uint*)column0, (uint*)column1, (uint*)column2, copy.Values, count);
                    break;
                default:
                    Copy8(source, (ulong*)column0, (ulong*)column1, (ulong*)column2, copy.Values, count);
                    break;
            }
        }

        void Copy1(byte* source, byte* column0, byte* column1, byte* column2, int values, int count)
        {
            int stride = RecordBytes;
            if (values == 3)
            {
                int i = 0;
                for (; i < count - 3; i += 4, source += 4 * stride)
                {
                    byte* second = source + stride, third = second + stride, fourth = third + stride;
                    *(uint*)(column0 + i) = (uint)(source[0] | second[0] << 8 | third[0] << 16 | fourth[0] << 24);
                    *(uint*)(column1 + i) = (uint)(source[1] | second[1] << 8 | third[1] << 16 | fourth[1] << 24);
                    *(uint*)(column2 + i) = (uint)(source[2] | second[2] << 8 | third[2] << 16 | fourth[2] << 24);
                }
                for (; i < count; i++, source += stride)
                {
                    column0[i] = source[0];
                    column1[i] = source[1];
                    column2[i] = source[2];
                }
                return;
            }
            for (int i = 0; i < count; i++, source += stride)
            {
                column0[i] = source[0];
                if (values > 1)
                    column1[i] = source[1];
            }
        }

        void Copy2(byte* source, ushort* column0, ushort* column1, ushort* column2, int values, int count)
        {
            int stride = RecordBytes;
            if (values == 3 && !IsBigEndian)
            {
                for (int i = 0; i < count; i++, source += stride)
                {
                    column0[i] = *(ushort*)source;
                    column1[i] = *(ushort*)(source + 2);
                    column2[i] = *(ushort*)(source + 4);
                }
                return;
            }
            for (int i = 0; i < count; i++, source += stride)
            {
                column0[i] = Load2(source);
                if (values > 1)
                    column1[i] = Load2(source + 2);
                if (values > 2)
                    column2[i] = Load2(source + 4);
            }
        }

        void Copy4(byte* source, uint* column0, uint* column1, uint* column2, int values, int count)
        {
            int stride = RecordBytes;
            if (values == 3 && !IsBigEndian)
            {
                int i = 0;
                for (; i < count - 1; i += 2, source += 2 * stride)
                {
                    byte* second = source + stride;
                    *(ulong*)(column0 + i) = *(uint*)source | (ulong)*(uint*)second << 32;
                    *(ulong*)(column1 + i) = *(uint*)(source + 4) | (ulong)*(uint*)(second + 4) << 32;
                    *(ulong*)(column2 + i) = *(uint*)(source + 8) | (ulong)*(uint*)(second + 8) << 32;
                }
                for (; i < count; i++, source += stride)
                {
                    column0[i] = *(uint*)source;
                    column1[i] = *(uint*)(source + 4);
                    column2[i] = *(uint*)(source + 8);
                }
                return;
            }
            for (int i = 0; i < count; i++, source += stride)
            {
                column0[i] = Load4(source);
                if (values > 1)
                    column1[i] = Load4(source + 4);
                if (values > 2)
                    column2[i] = Load4(source + 8);
            }
        }

        void Copy8(byte* source, ulong* column0, ulong* column1, ulong* column2, int values, int count)
        {
            int stride = RecordBytes;
            if (values == 3 && !IsBigEndian)
            {
                for (int i = 0; i < count; i++, source += stride)
                {
                    column0[i] = *(ulong*)source;
                    column1[i] = *(ulong*)(source + 8);
                    column2[i] = *(ulong*)(source + 16);
                }
                return;
            }
            for (int i = 0; i < count; i++, source += stride)
            {
                column0[i] = Load8(source);
                if (values > 1)
                    column1[i] = Load8(source + 8);
                if (values > 2)
                    column2[i] = Load8(source + 16);
            }
        }

        ushort Load2(byte* p) => IsBigEndian ? (ushort)(p[0] << 8 | p[1]) : *(ushort*)p;

        uint Load4(byte* p) => IsBigEndian ? PlyBytes.Reverse(*(uint*)p) : *(uint*)p;

        ulong Load8(byte* p) => IsBigEndian ? PlyBytes.Reverse(*(ulong*)p) : *(ulong*)p;
    }
}
