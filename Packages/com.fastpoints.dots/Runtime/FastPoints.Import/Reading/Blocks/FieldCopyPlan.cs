using System;
using System.Collections;
using System.Collections.Generic;

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
                bool isTriple = i + 2 < fields.Length && Follows(fields[i], fields[i + 1])
                    && Follows(fields[i + 1], fields[i + 2]) && (!isBigEndian || fields[i].Type.SizeOf() == 1);
                copies.Add(new FieldCopy
                {
                    RecordByte = fields[i].ByteOffset,
                    Column0 = columns[i].OffsetBytes,
                    Column1 = isTriple ? columns[i + 1].OffsetBytes : 0,
                    Column2 = isTriple ? columns[i + 2].OffsetBytes : 0,
                    Kind = KindOf(fields[i], isTriple, isBigEndian),
                    BitShift = (byte)fields[i].BitShift,
                    BitMask = (byte)((1 << fields[i].BitWidth) - 1),
                });
                if (isTriple)
                    i += 2;
            }
            JoinPositionAndColor(copies);
            return copies.ToArray();
        }

        static void JoinPositionAndColor(List<FieldCopy> copies)
        {
            int at = copies.FindIndex(copy => copy.Kind == FieldCopyKind.TripleOfBytes4 && copy.RecordByte == 0);
            int colorAt = copies.FindIndex(copy => copy.Kind == FieldCopyKind.TripleOfBytes2);
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

        static FieldCopyKind KindOf(PointField field, bool isTriple, bool isBigEndian) => field.Type.SizeOf() switch
        {
            1 => isTriple ? FieldCopyKind.TripleOfBytes1 : field.IsBits ? FieldCopyKind.Bits : FieldCopyKind.Bytes1,
            2 => isTriple ? FieldCopyKind.TripleOfBytes2 : isBigEndian ? FieldCopyKind.Bytes2Reversed : FieldCopyKind.Bytes2,
            4 => isTriple ? FieldCopyKind.TripleOfBytes4 : isBigEndian ? FieldCopyKind.Bytes4Reversed : FieldCopyKind.Bytes4,
            _ => isTriple ? FieldCopyKind.TripleOfBytes8 : isBigEndian ? FieldCopyKind.Bytes8Reversed : FieldCopyKind.Bytes8,
        };
    }

    internal enum FieldCopyKind : byte
    {
        Bits,
        Bytes1,
        Bytes2,
        Bytes4,
        Bytes8,
        Bytes2Reversed,
        Bytes4Reversed,
        Bytes8Reversed,
        // Three neighbouring values (R, G, B; X, Y, Z) into isTriple columns in one pass over the records.
        TripleOfBytes1,
        TripleOfBytes2,
        TripleOfBytes4,
        TripleOfBytes8,
        PositionAndColor, // Six columns in one pass: the usual request, and faster than two passes.
    }

    // From a field of each record to one or several columns. Blittable: jobs carry arrays of these.
    internal struct FieldCopy
    {
        public int RecordByte;
        public int Column0;
        public int Column1;
        public int Column2;

        // For PositionAndColor.
        public int ColorByte;
        public int Red;
        public int Green;
        public int Blue;

        public FieldCopyKind Kind;
        public byte BitShift;
        public byte BitMask;
    }

    internal struct PointField
    {
        public string Name;
        public readonly AttributeType Type; // Bit fields are UInt8.

        public int ByteOffset;
        public readonly int BitShift;
        public readonly int BitWidth; // 0 for a value of whole bytes.
        public readonly double Scale; // Value = stored * Scale + Offset; 1 and 0 unless the file says otherwise.

        public readonly double Offset;

        public PointField(string name, AttributeType type, int byteOffset, double scale = 1, double offset = 0)
        {
            Name = name;
            Type = type;
            ByteOffset = byteOffset;
            BitShift = 0;
            BitWidth = 0;
            Scale = scale;
            Offset = offset;
        }

        public PointField(string name, int byteOffset, int bitShift, int bitWidth) : this(name, AttributeType.UInt8, byteOffset)
        {
            BitShift = bitShift;
            BitWidth = bitWidth;
        }

        public readonly bool IsBits => BitWidth != 0;

        public readonly PointAttribute ToAttribute() => new PointAttribute(Name, Type, Scale, Offset);
    }

    internal sealed class PointFields : IReadOnlyList<PointField>
    {
        readonly List<PointField> m_fields = new List<PointField>();
        readonly Dictionary<string, int> m_indexOfName = new Dictionary<string, int>();

        public int Count => m_fields.Count;

        public PointField this[int index] => m_fields[index];

        // Files repeat names, and extra bytes use those of standard fields: columns are found by name, so a later one
        // is numbered. Returns the field under its final name.
        public PointField Add(PointField field)
        {
            string name = field.Name;
            for (int number = 2; m_indexOfName.ContainsKey(field.Name); number++)
                field.Name = name + " (" + NumberText.Of(number) + ")";
            m_indexOfName.Add(field.Name, m_fields.Count);
            m_fields.Add(field);
            return field;
        }

        public int IndexOf(PointAttribute column) =>
            m_indexOfName.TryGetValue(column.Name, out int index) && m_fields[index].Type == column.Type
                ? index
                : throw new ArgumentException("the records have no attribute " + column);

        public bool TryFind(string name, out PointField field)
        {
            bool found = m_indexOfName.TryGetValue(name, out int index);
            field = found ? m_fields[index] : default;
            return found;
        }

        public PointSchema ToSchema() => new PointSchema(m_fields.ConvertAll(field => field.ToAttribute()));

        public IEnumerator<PointField> GetEnumerator() => m_fields.GetEnumerator();

        IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();
    }
}
