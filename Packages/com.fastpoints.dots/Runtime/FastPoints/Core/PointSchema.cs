using System;
using System.Collections;
using System.Collections.Generic;

namespace FastPoints
{
    /// <summary>The attributes of a cloud, a file or a batch, in the order of its columns. Immutable.</summary>
    public sealed class PointSchema : IReadOnlyList<PointAttribute>, IEquatable<PointSchema>
    {
        readonly PointAttribute[] m_attributes;

        public PointSchema(IEnumerable<PointAttribute> attributes)
        {
            m_attributes = new List<PointAttribute>(attributes).ToArray();
            foreach (var attribute in m_attributes)
                BytesPerPoint += attribute.Type.SizeOf();
        }

        public int Count => m_attributes.Length;
        public PointAttribute this[int index] => m_attributes[index];

        /// <summary>Sum of the column widths, without alignment.</summary>
        public int BytesPerPoint { get; }

        public bool Has(string name) => IndexOf(name) >= 0;

        public bool HasColor => Has(AttributeNames.Red) && Has(AttributeNames.Green) && Has(AttributeNames.Blue);

        /// <returns>The column of that name, or -1.</returns>
        public int IndexOf(string name)
        {
            for (int i = 0; i < m_attributes.Length; i++)
                if (m_attributes[i].Name == name)
                    return i;
            return -1;
        }

        /// <summary>Selects the attributes with these names, in this schema's order.</summary>
        public PointSchema Select(params string[] names)
        {
            var chosen = new List<PointAttribute>();
            foreach (var attribute in m_attributes)
                if (Array.IndexOf(names, attribute.Name) >= 0)
                    chosen.Add(attribute);
            return new PointSchema(chosen);
        }

        // The position, and those of the attributes that it has.
        internal PointSchema SelectWithPosition(PointSchema attributes)
        {
            var names = new List<string> { AttributeNames.X, AttributeNames.Y, AttributeNames.Z };
            foreach (var attribute in attributes)
                names.Add(attribute.Name);
            return Select(names.ToArray());
        }

        public bool Equals(PointSchema other)
        {
            if (other == null || other.Count != Count)
                return false;
            for (int i = 0; i < Count; i++)
                if (!m_attributes[i].Equals(other[i]))
                    return false;
            return true;
        }

        public override bool Equals(object obj) => Equals(obj as PointSchema);
        public override int GetHashCode() => Count * 397 ^ BytesPerPoint;
        public IEnumerator<PointAttribute> GetEnumerator() => ((IEnumerable<PointAttribute>)m_attributes).GetEnumerator();
        IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();
        public override string ToString() => string.Join(", ", (IEnumerable<PointAttribute>)m_attributes);
    }

    /// <summary>One component that every point of a cloud has: its name, its type and how to read its stored values.</summary>
    public sealed class PointAttribute : IEquatable<PointAttribute>
    {
        /// <summary>The field's usual name (<see cref="AttributeNames"/>), or the name that the file uses.</summary>
        public string Name { get; }

        public AttributeType Type { get; }

        /// <summary>Value = stored * Scale + Offset: 1 and 0 except for scaled extra bytes and, elsewhere, positions.</summary>
        public double Scale { get; }

        public double Offset { get; }

        public PointAttribute(string name, AttributeType type, double scale = 1, double offset = 0) =>
            (Name, Type, Scale, Offset) = (name, type, scale, offset);

        public bool Equals(PointAttribute other) =>
            other != null && Name == other.Name && Type == other.Type && Scale.Equals(other.Scale) && Offset.Equals(other.Offset);

        public override bool Equals(object obj) => Equals(obj as PointAttribute);
        public override int GetHashCode() => Name.GetHashCode() * 31 + (int)Type;
        public override string ToString() => Name + ":" + Type;
    }
}
