using System;

namespace FastPoints.Tests
{
    public static class RecordFields
    {
        public static int Int32(byte[] record, int at) => BitConverter.ToInt32(record, at);
        public static ushort UInt16(byte[] record, int at) => BitConverter.ToUInt16(record, at);
        public static long Int64(byte[] record, int at) => BitConverter.ToInt64(record, at);

        public static byte[] Slice(byte[] bytes, int at, int count)
        {
            var slice = new byte[count];
            Array.Copy(bytes, at, slice, 0, count);
            return slice;
        }
    }
}
