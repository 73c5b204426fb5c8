using System.Collections.Generic;
using FastPoints.Base;
using FastPoints.Points;

namespace FastPoints.Files
{
    /// <summary>Everything that a record of one file holds: the fields of its point format, then extra bytes.</summary>
    internal sealed class LasRecordLayout
    {
        readonly List<LasField> m_fields = new List<LasField>();
        readonly Dictionary<string, int> m_indexOfName = new Dictionary<string, int>();

        /// <param name="recordBytes">According to the header; at least the format's own.</param>
        /// <param name="extra">Described extra bytes, with offsets from the record's start. The rest of the record becomes
        /// columns of single bytes named <c>ExtraBytes[i]</c>, so that no part of a record is lost.</param>
        public LasRecordLayout(LasPointFormat format, int recordBytes, IEnumerable<LasField> extra)
        {
            Format = format;
            RecordBytes = recordBytes;
            foreach (var field in format.Fields)
                Add(field);
            int end = format.RecordBytes;
            foreach (var field in extra)
            {
                Add(field);
                end = field.ByteOffset + field.Type.SizeOf();
            }
            DescribedBytes = end;
            for (int i = end; i < recordBytes; i++)
                Add(new LasField("ExtraBytes[" + NumberText.Of(i - end) + "]", AttributeType.UInt8, i));

            var attributes = new List<PointAttribute>(m_fields.Count);
            foreach (var field in m_fields)
                attributes.Add(field.ToAttribute());
            Schema = new PointSchema(attributes);
        }

        public LasPointFormat Format { get; }
        public int RecordBytes { get; }

        /// <summary>End of the last byte that the format or a description covers.</summary>
        public int DescribedBytes { get; }

        public IReadOnlyList<LasField> Fields => m_fields;

        /// <summary>One attribute for each field, in the same order.</summary>
        public PointSchema Schema { get; }

        public bool TryFind(string name, out LasField field)
        {
            bool found = m_indexOfName.TryGetValue(name, out int index);
            field = found ? m_fields[index] : default;
            return found;
        }

        void Add(LasField field)
        {
            // Files give extra bytes the names of standard fields, and one name twice: columns are found by name, so a later one
            // is numbered.
            string name = field.Name;
            for (int number = 2; m_indexOfName.ContainsKey(name); number++)
                name = field.Name + " (" + NumberText.Of(number) + ")";
            if (name != field.Name)
                field = new LasField(name, field.Type, field.ByteOffset, field.Scale, field.Offset);
            m_indexOfName.Add(name, m_fields.Count);
            m_fields.Add(field);
        }
    }
}
