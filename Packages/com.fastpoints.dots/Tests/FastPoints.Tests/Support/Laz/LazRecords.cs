using System;
using System.Collections.Generic;
using FastPoints.Las;

namespace FastPoints.Tests
{
    static class LazRecords
    {
        public static List<byte[]> Make(int pointFormat, int extraBytes, int count, int seed)
        {
            var random = new Random(seed);
            int core = LasPointFormat.Of(pointFormat).RecordBytes;
            var records = new List<byte[]>(count);
            var last = new byte[core + extraBytes];
            random.NextBytes(last);
            Put(last, 0, 44123400, 4);
            Put(last, 4, 561234500, 4);
            for (int i = 0; i < count; i++)
            {
                var record = (byte[])last.Clone();
                MoveCore(record, pointFormat >= 6, random);
                MoveRest(record, pointFormat, core, random);
                records.Add(record);
                last = record;
            }
            return records;
        }

        static void MoveCore(byte[] record, bool isExtended, Random random)
        {
            bool isExtreme = random.Next(300) == 0;
            for (int axis = 0; axis < 3; axis++)
            {
                int value = RecordFields.Int32(record, 4 * axis);
                value = isExtreme ? random.Next(2) == 0 ? int.MinValue : int.MaxValue
                    : Math.Abs((long)value) > 1 << 30 ? 1000 : unchecked(value + Spread(random));
                Put(record, 4 * axis, value, 4);
            }
            if (random.Next(2) == 0)
                Put(record, 12, random.Next(20) == 0 ? random.Next(65536)
                    : RecordFields.UInt16(record, 12) + random.Next(-40, 40), 2);
            int returns = isExtended ? 16 : 8, shift = isExtended ? 4 : 3;
            if (random.Next(3) == 0)
            {
                int n = random.Next(1, returns), r = random.Next(8) == 0 ? random.Next(returns) : random.Next(1, n + 1);
                record[14] = (byte)(isExtended ? n << shift | r : record[14] & 0xC0 | n << shift | r);
            }
            if (random.Next(20) == 0)
                record[isExtended ? 15 : 14] ^= (byte)(isExtended ? 1 << random.Next(4) : 1 << random.Next(6, 8));
            if (isExtended && random.Next(10) == 0)
                record[15] = (byte)(record[15] & 0x0F | random.Next(256) & 0xF0);
            if (random.Next(5) == 0)
                record[isExtended ? 16 : 15] = (byte)random.Next(random.Next(4) == 0 ? 256 : 6);
            if (random.Next(30) == 0)
                record[17] = (byte)random.Next(256);
            int angle = isExtended ? 18 : 16;
            if (random.Next(6) == 0)
                Put(record, angle, RecordFields.UInt16(record, angle) + random.Next(-3, 4), isExtended ? 2 : 1);
            if (random.Next(25) == 0)
                Put(record, isExtended ? 20 : 18, random.Next(3) == 0 ? random.Next(65536) : random.Next(4), 2);
            if (isExtended)
                MoveTime(record, 22, random);
        }

        static void MoveRest(byte[] record, int pointFormat, int core, Random random)
        {
            int at = pointFormat >= 6 ? 30 : 20;
            if (pointFormat == 1 || pointFormat >= 3 && pointFormat <= 5)
            {
                MoveTime(record, at, random);
                at += 8;
            }
            bool hasColor = pointFormat == 2 || pointFormat == 3 || pointFormat == 5 || pointFormat == 7 || pointFormat == 8
                || pointFormat == 10;
            if (hasColor)
            {
                MoveColor(record, at, random);
                at += 6;
            }
            if (pointFormat == 8 || pointFormat == 10)
            {
                if (random.Next(2) == 0)
                    Put(record, at, RecordFields.UInt16(record, at) + random.Next(-300, 300), 2);
                at += 2;
            }
            if (at < core)
                MoveWave(record, at, random);
            for (int i = core; i < record.Length; i++)
                if (random.Next(3) == 0)
                    record[i] += (byte)random.Next(-2, 3);
        }

        static void MoveTime(byte[] record, int at, Random random)
        {
            double time = BitConverter.Int64BitsToDouble(RecordFields.Int64(record, at));
            if (double.IsNaN(time) || Math.Abs(time) > 1e20 || Math.Abs(time) < 1)
                time = 3e5;
            int kind = random.Next(100);
            if (kind < 40)
                time += 2e-5;
            else if (kind < 50)
                time += random.Next(1, 700) * 2e-5;
            else if (kind < 54)
                time -= random.Next(1, 40) * 2e-5;
            else if (kind < 57)
                time += random.NextDouble() < 0.5 ? 1000 : -1000;
            else if (kind < 58)
                time = random.NextDouble() * 1e9;
            else if (kind < 59)
                time = -time;
            Put(record, at, BitConverter.DoubleToInt64Bits(time), 8);
        }

        static void MoveColor(byte[] record, int at, Random random)
        {
            int kind = random.Next(10);
            for (int i = 0; i < 3; i++)
            {
                int value = RecordFields.UInt16(record, at + 2 * i);
                int next = kind < 3 ? value
                    : kind < 5 ? RecordFields.UInt16(record, at) + (i == 0 ? random.Next(-9, 10) : 0)
                    : kind < 8 ? value + random.Next(-600, 600) : kind < 9 ? value & 0xFF00 | value >> 8 : random.Next(65536);
                Put(record, at + 2 * i, next, 2);
            }
        }

        static void MoveWave(byte[] record, int at, Random random)
        {
            if (random.Next(4) == 0)
                record[at] = (byte)random.Next(4);
            long offset = RecordFields.Int64(record, at + 1);
            int kind = random.Next(8);
            if (kind < 4)
                offset = unchecked(offset + BitConverter.ToUInt32(record, at + 9));
            else if (kind < 6)
                offset = unchecked(offset + random.Next(-5000, 5000));
            else if (kind < 7)
                offset = unchecked((long)(random.NextDouble() * 1e18));
            Put(record, at + 1, offset, 8);
            for (int i = 0; i < 5; i++)
                if (random.Next(2) == 0)
                    Put(record, at + 9 + 4 * i, unchecked(RecordFields.Int32(record, at + 9 + 4 * i) + Spread(random)), 4);
        }

        /// <summary>A difference of a random number of bits.</summary>
        static int Spread(Random random)
        {
            int bits = random.Next(10) == 0 ? random.Next(1, 30) : random.Next(1, 9);
            return random.Next(-(1 << bits), 1 << bits);
        }

        static void Put(byte[] record, int at, long value, int bytes)
        {
            for (int i = 0; i < bytes; i++)
                record[at + i] = (byte)(value >> 8 * i);
        }
    }
}
