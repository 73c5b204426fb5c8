using System;
using System.Collections.Generic;
using FastPoints.Core;

namespace FastPoints.Reading
{
    /// <summary>Plans the passes over records that fill a batch's columns; the same plan packs columns into records.</summary>
    internal static class FieldCopyPlan
    {
        /// <param name="fields">What a record holds.</param>
        /// <param name="batch">Its schema says what is wanted, its columns where it goes.</param>
        /// <param name="isBigEndian">The byte order of the records.</param>
        /// <exception cref="ArgumentException">The records lack an attribute, or have it in another type.</exception>
        public static FieldCopy[] Make(PointFields fields, PointBatch batch, bool isBigEndian = false)
        {
            var wanted = new PointField[batch.Schema.Count];
            var columns = new PointColumn[wanted.Length];
            for (int i = 0; i < wanted.Length; i++)
            {
                wanted[i] = fields[fields.IndexOf(batch.Schema[i])];
                columns[i] = batch.Column(i);
            }
            return Make(wanted, columns, isBigEndian);
        }

        /// <summary>The same for chosen columns of a batch.</summary>
        /// <param name="fields">Where the wanted values lie in a record.</param>
        /// <param name="columns">Where each of them goes in the batch.</param>
        public static FieldCopy[] Make(PointField[] fields, PointColumn[] columns, bool isBigEndian = false)
        {
            var copies = new List<FieldCopy>(fields.Length);
            for (int i = 0; i < fields.Length; i++)
            {
                bool three = i + 2 < fields.Length && Follows(fields[i], fields[i + 1]) && Follows(fields[i + 1], fields[i + 2])
                    && (!isBigEndian || fields[i].Type.SizeOf() == 1);
                copies.Add(new FieldCopy
                {
                    RecordByte = fields[i].ByteOffset,
                    Column0 = columns[i].OffsetBytes,
                    Column1 = three ? columns[i + 1].OffsetBytes : 0,
                    Column2 = three ? columns[i + 2].OffsetBytes : 0,
                    Kind = KindOf(fields[i], three, isBigEndian),
                    BitShift = (byte)fields[i].BitShift,
                    BitMask = (byte)((1 << fields[i].BitWidth) - 1),
                });
                if (three)
                    i += 2;
            }
            JoinPositionAndColor(copies);
            return copies.ToArray();
        }

        static void JoinPositionAndColor(List<FieldCopy> copies)
        {
            int at = copies.FindIndex(copy => copy.Kind == FieldCopyKind.ThreeOfFour && copy.RecordByte == 0);
            int colorAt = copies.FindIndex(copy => copy.Kind == FieldCopyKind.ThreeOfTwo);
            if (at < 0 || colorAt < 0)
                return;
            var joined = copies[at];
            var color = copies[colorAt];
            joined.Kind = FieldCopyKind.PositionAndColor;
            joined.ColorByte = color.RecordByte;
            joined.Red = color.Column0;
            joined.Green = color.Column1;
            joined.Blue = color.Column2;
            copies[at] = joined;
            copies.RemoveAt(colorAt);
        }

        /// <summary>Whether two fields of one width lie side by side, as the axes and the colours do.</summary>
        static bool Follows(PointField first, PointField second) => !first.IsBits && !second.IsBits
            && second.Type.SizeOf() == first.Type.SizeOf() && second.ByteOffset == first.ByteOffset + first.Type.SizeOf();

        static FieldCopyKind KindOf(PointField field, bool three, bool isBigEndian) => field.Type.SizeOf() switch
        {
            1 => three ? FieldCopyKind.ThreeOfOne : field.IsBits ? FieldCopyKind.Bits : FieldCopyKind.One,
            2 => three ? FieldCopyKind.ThreeOfTwo : isBigEndian ? FieldCopyKind.TwoReversed : FieldCopyKind.Two,
            4 => three ? FieldCopyKind.ThreeOfFour : isBigEndian ? FieldCopyKind.FourReversed : FieldCopyKind.Four,
            _ => three ? FieldCopyKind.ThreeOfEight : isBigEndian ? FieldCopyKind.EightReversed : FieldCopyKind.Eight,
        };
    }

    /// <summary>How one <see cref="FieldCopy"/> moves values. Sizes in bytes.</summary>
    internal enum FieldCopyKind : byte
    {
        /// <summary>Some bits of one byte.</summary>
        Bits,
        One,
        Two,
        Four,
        Eight,
        /// <summary>Values whose bytes lie in the other order.</summary>
        TwoReversed,
        FourReversed,
        EightReversed,
        /// <summary>Three neighbouring values (R, G, B; X, Y, Z) into three columns in one pass over the records.</summary>
        ThreeOfOne,
        ThreeOfTwo,
        ThreeOfFour,
        ThreeOfEight,
        /// <summary>X, Y, Z and R, G, B, six columns in one pass: what most scenes want, and faster than two passes.</summary>
        PositionAndColor,
    }

    /// <summary>A copy from a place in each record to one or several columns. Blittable: jobs carry arrays of these.</summary>
    internal struct FieldCopy
    {
        /// <summary>Offset of the value in the record.</summary>
        public int RecordByte;

        /// <summary>Offset of the column's first value in the batch.</summary>
        public int Column0;

        /// <summary>The second and third column of the kinds that have them.</summary>
        public int Column1;
        public int Column2;

        /// <summary>Like the first four, for the colour of <see cref="FieldCopyKind.PositionAndColor"/>.</summary>
        public int ColorByte;
        public int Red;
        public int Green;
        public int Blue;

        public FieldCopyKind Kind;
        public byte BitShift;

        /// <summary>Mask to apply after the shift.</summary>
        public byte BitMask;
    }
}
