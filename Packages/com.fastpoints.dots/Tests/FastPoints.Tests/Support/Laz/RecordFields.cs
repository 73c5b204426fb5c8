using System;

namespace FastPoints.Tests
{
    public static class RecordFields
    {
        public static int Int32(byte[] record, int at) => BitConverter.ToInt32(record, at);
        public static ushort UInt16(byte[] record, int at) => BitConverter.ToUInt16(record, at);
        public static long Int64(byte[] record, int at) => BitConverter.ToInt64(record, at);
    }
}
