using System;
using System.Linq;
using FastPoints.Tests.Reading;

namespace FastPoints.Tests.E57
{
    static class E57TestScans
    {
        public static double[] Reals(int count, double first, double step) =>
            Enumerable.Range(0, count).Select(i => first + i * step).ToArray();

        public static long[] Longs(int count, Func<int, long> value) => Enumerable.Range(0, count).Select(value).ToArray();

        public static long[] RandomLongs(int count, long minimum, long maximum, int seed)
        {
            var random = new Random(seed);
            var bytes = new byte[8];
            ulong range = (ulong)maximum - (ulong)minimum;
            return Longs(count, i =>
            {
                random.NextBytes(bytes);
                ulong raw = BitConverter.ToUInt64(bytes, 0);
                return (long)((ulong)minimum + (range == ulong.MaxValue ? raw : raw % (range + 1)));
            });
        }

        public static E57TestScan Grid(int count, double scale = 0.001, double offset = 0, int seed = 1) => new E57TestScan(
            E57TestField.Scaled("cartesianX", -100000, 120000, scale, offset, RandomLongs(count, -100000, 120000, seed)),
            E57TestField.Scaled("cartesianY", 5, 4100, scale, offset, RandomLongs(count, 5, 4100, seed + 1)),
            E57TestField.Scaled("cartesianZ", 7, 7, scale, offset, Longs(count, i => 7)));

        public static E57TestScan Floats(int count, double first = 0) => new E57TestScan(
            E57TestField.Single("cartesianX", Reals(count, first, 0.25)),
            E57TestField.Single("cartesianY", Reals(count, -3, 0.5)),
            E57TestField.Single("cartesianZ", Reals(count, 1, -0.125)));

        public static byte[] File(params E57TestScan[] scans) => new E57FileWriter(scans).ToArray();

        public static long[] Integers(FileContents contents, string name) => contents.TypeOf(name) switch
        {
            AttributeType.UInt8 => contents.Column<byte>(name).Select(v => (long)v).ToArray(),
            AttributeType.Int8 => contents.Column<sbyte>(name).Select(v => (long)v).ToArray(),
            AttributeType.UInt16 => contents.Column<ushort>(name).Select(v => (long)v).ToArray(),
            AttributeType.Int16 => contents.Column<short>(name).Select(v => (long)v).ToArray(),
            AttributeType.UInt32 => contents.Column<uint>(name).Select(v => (long)v).ToArray(),
            AttributeType.Int32 => contents.Column<int>(name).Select(v => (long)v).ToArray(),
            _ => contents.Column<long>(name),
        };
    }
}
