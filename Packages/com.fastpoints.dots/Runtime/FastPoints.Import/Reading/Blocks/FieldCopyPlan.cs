using System;
using System.Collections.Generic;
using FastPoints.Core;

namespace FastPoints.Reading
{
    // The passes over records that fill a batch's columns; the same plan packs columns into records.
    internal static class FieldCopyPlan
    {
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

    internal enum FieldCopyKind : byte
    {
        Bits,
        One,
        Two,
        Four,
        Eight,
        TwoReversed,
        FourReversed,
        EightReversed,
        // Three neighbouring values (R, G, B; X, Y, Z) into three columns in one pass over the records.
        ThreeOfOne,
        ThreeOfTwo,
        ThreeOfFour,
        ThreeOfEight,
        // Six columns in one pass: what most scenes want, and faster than two passes.
        PositionAndColor,
    }

    // From a place in each record to one or several columns. Blittable: jobs carry arrays of these.
    internal struct FieldCopy
    {
        public int RecordByte;
        public int Column0;
        public int Column1;
        public int Column2;

        // Of PositionAndColor.
        public int ColorByte;
        public int Red;
        public int Green;
        public int Blue;

        public FieldCopyKind Kind;
        public byte BitShift;
        public byte BitMask;
    }
}
