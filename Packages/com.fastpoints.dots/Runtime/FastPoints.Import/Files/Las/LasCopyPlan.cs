using System;
using System.Collections.Generic;
using FastPoints.Points;

namespace FastPoints.Files
{
    /// <summary>Plans the passes over records that fill a batch's columns; the same plan packs columns into records.</summary>
    internal static class LasCopyPlan
    {
        /// <param name="layout">The layout of the records.</param>
        /// <param name="batch">Its schema says what is wanted, its columns where it goes.</param>
        /// <exception cref="ArgumentException">The records lack an attribute, or have it in another type.</exception>
        public static LasFieldCopy[] Make(LasRecordLayout layout, PointBatch batch)
        {
            var fields = new LasField[batch.Schema.Count];
            var columns = new PointColumn[fields.Length];
            for (int i = 0; i < fields.Length; i++)
            {
                if (!layout.TryFind(batch.Schema[i].Name, out fields[i]) || fields[i].Type != batch.Schema[i].Type)
                    throw new ArgumentException("the records have no attribute " + batch.Schema[i]);
                columns[i] = batch.Column(i);
            }
            return Make(fields, columns);
        }

        /// <summary>The same for records of any format.</summary>
        /// <param name="fields">Where the wanted values lie in a record.</param>
        /// <param name="columns">Where each of them goes in the batch.</param>
        public static LasFieldCopy[] Make(LasField[] fields, PointColumn[] columns)
        {
            var copies = new List<LasFieldCopy>(fields.Length);
            for (int i = 0; i < fields.Length; i++)
            {
                bool three = i + 2 < fields.Length && Follows(fields[i], fields[i + 1]) && Follows(fields[i + 1], fields[i + 2]);
                copies.Add(new LasFieldCopy
                {
                    RecordByte = fields[i].ByteOffset,
                    Column0 = columns[i].OffsetBytes,
                    Column1 = three ? columns[i + 1].OffsetBytes : 0,
                    Column2 = three ? columns[i + 2].OffsetBytes : 0,
                    Kind = KindOf(fields[i], three),
                    BitShift = (byte)fields[i].BitShift,
                    BitMask = (byte)((1 << fields[i].BitWidth) - 1),
                });
                if (three)
                    i += 2;
            }
            JoinPositionAndColor(copies);
            return copies.ToArray();
        }

        static void JoinPositionAndColor(List<LasFieldCopy> copies)
        {
            int at = copies.FindIndex(copy => copy.Kind == LasCopyKind.ThreeOfFour && copy.RecordByte == 0);
            int colorAt = copies.FindIndex(copy => copy.Kind == LasCopyKind.ThreeOfTwo);
            if (at < 0 || colorAt < 0)
                return;
            var joined = copies[at];
            var color = copies[colorAt];
            joined.Kind = LasCopyKind.PositionAndColor;
            joined.ColorByte = color.RecordByte;
            joined.Red = color.Column0;
            joined.Green = color.Column1;
            joined.Blue = color.Column2;
            copies[at] = joined;
            copies.RemoveAt(colorAt);
        }

        /// <summary>Whether two fields of two or of four bytes lie side by side, as the axes and the colours do.</summary>
        static bool Follows(LasField first, LasField second)
        {
            int bytes = first.Type.SizeOf();
            return (bytes == 2 || bytes == 4) && second.Type.SizeOf() == bytes && second.ByteOffset == first.ByteOffset + bytes;
        }

        static LasCopyKind KindOf(LasField field, bool three)
        {
            switch (field.Type.SizeOf())
            {
                case 1:
                    return field.IsBits ? LasCopyKind.Bits : LasCopyKind.One;
                case 2:
                    return three ? LasCopyKind.ThreeOfTwo : LasCopyKind.Two;
                case 4:
                    return three ? LasCopyKind.ThreeOfFour : LasCopyKind.Four;
                default:
                    return LasCopyKind.Eight;
            }
        }
    }

    /// <summary>How one <see cref="LasFieldCopy"/> moves values. Sizes in bytes.</summary>
    internal enum LasCopyKind : byte
    {
        /// <summary>Some bits of one byte.</summary>
        Bits,
        One,
        Two,
        Four,
        Eight,
        /// <summary>Three neighbouring values (R, G, B; X, Y, Z) into three columns in one pass over the records.</summary>
        ThreeOfTwo,
        ThreeOfFour,
        /// <summary>X, Y, Z and R, G, B, six columns in one pass: what most scenes want, and faster than two passes.</summary>
        PositionAndColor,
    }

    /// <summary>A copy from a place in each record to one or several columns. Blittable: jobs carry arrays of these.</summary>
    internal struct LasFieldCopy
    {
        /// <summary>Offset of the value in the record.</summary>
        public int RecordByte;

        /// <summary>Offset of the column's first value in the batch.</summary>
        public int Column0;

        /// <summary>The second and third column of the kinds that have them.</summary>
        public int Column1;
        public int Column2;

        /// <summary>Like the first four, for the colour of <see cref="LasCopyKind.PositionAndColor"/>.</summary>
        public int ColorByte;
        public int Red;
        public int Green;
        public int Blue;

        public LasCopyKind Kind;
        public byte BitShift;

        /// <summary>Mask to apply after the shift.</summary>
        public byte BitMask;
    }
}
