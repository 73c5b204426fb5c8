using System;
using System.Collections;
using System.Collections.Generic;
using FastPoints.Core;

namespace FastPoints.Reading
{
    /// <summary>The location of one attribute in a point record.</summary>
    internal struct PointField
    {
        public string Name;

        /// <summary>Type of the value in a column. Bit fields are UInt8.</summary>
        public readonly AttributeType Type;

        public int ByteOffset;

        /// <summary>Lowest bit of a bit field within its byte.</summary>
        public readonly int BitShift;

        /// <summary>Bits of a bit field, or 0 for a value with bytes of its own.</summary>
        public readonly int BitWidth;

        /// <summary>Value = stored * Scale + Offset; 1 and 0 unless the file says otherwise.</summary>
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

    /// <summary>The fields of a record, found by name.</summary>
    internal sealed class PointFields : IReadOnlyList<PointField>
    {
        readonly List<PointField> m_fields = new List<PointField>();
        readonly Dictionary<string, int> m_indexOfName = new Dictionary<string, int>();

        public int Count => m_fields.Count;

        public PointField this[int index] => m_fields[index];

        /// <summary>Adds a field. Files give one name twice, and extra bytes the names of standard fields: columns are found by
        /// name, so a later one is numbered.</summary>
        /// <returns>The field under its final name.</returns>
        public PointField Add(PointField field)
        {
            string name = field.Name;
            for (int number = 2; m_indexOfName.ContainsKey(field.Name); number++)
                field.Name = name + " (" + NumberText.Of(number) + ")";
            m_indexOfName.Add(field.Name, m_fields.Count);
            m_fields.Add(field);
            return field;
        }

        /// <summary>Index of the field that a column is filled from.</summary>
        /// <exception cref="ArgumentException">The records lack the attribute, or have it in another type.</exception>
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

        /// <summary>One attribute for each field, in the same order.</summary>
        public PointSchema ToSchema() => new PointSchema(m_fields.ConvertAll(field => field.ToAttribute()));

        public IEnumerator<PointField> GetEnumerator() => m_fields.GetEnumerator();

        IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();
    }
}
