using System;
using System.Collections;
using System.Collections.Generic;
using FastPoints.Core;

namespace FastPoints.Reading
{
    internal struct PointField
    {
        public string Name;

        // Bit fields are UInt8.
        public readonly AttributeType Type;

        public int ByteOffset;
        public readonly int BitShift;

        // 0 for a value with bytes of its own.
        public readonly int BitWidth;

        // Value = stored * Scale + Offset; 1 and 0 unless the file says otherwise.
        public readonly double Scale;

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

        // Files give one name twice, and extra bytes the names of standard fields: columns are found by name, so a later one is
        // numbered. Returns the field under its final name.
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
