using System;
using System.Collections.Generic;
using FastPoints.Base;
using FastPoints.Points;

namespace FastPoints.Files
{
    /// <summary>The attributes of a Potree cloud, one behind the other: a record, and the columns that it becomes.</summary>
    sealed class PotreeLayout
    {
        /// <summary>Longer records than any cloud has.</summary>
        const int MaxRecordBytes = 1 << 14;

        readonly List<PotreeAttribute> m_attributes = new List<PotreeAttribute>();
        readonly Dictionary<string, LasField> m_fieldOfColumn = new Dictionary<string, LasField>();
        readonly Dictionary<string, int> m_attributeOfColumn = new Dictionary<string, int>();

        /// <exception cref="PointCloudException">There is no position, or records are too long.</exception>
        public PotreeLayout(IEnumerable<PotreeAttribute> attributes, string path)
        {
            var columns = new List<PointAttribute>();
            long bytes = 0;
            foreach (var attribute in attributes)
            {
                if (attribute.IsPackedNormal && m_attributes.Exists(other => other.IsPackedNormal))
                    attribute.BecomeBytes();
                attribute.RecordOffset = (int)bytes;
                bytes += attribute.Bytes;
                if (bytes > MaxRecordBytes)
                    throw PointCloudException.Wanted(FailureCode.Unsupported, path, -1, "bytes of a point",
                        "at most " + NumberText.Of(MaxRecordBytes), bytes);
                for (int i = 0; i < attribute.Columns.Length; i++)
                    columns.Add(AddColumn(attribute, i));
                m_attributes.Add(attribute);
                if (attribute.IsPosition && Position == null)
                    Position = attribute;
            }
            if (Position == null)
                throw PointCloudException.Wanted(FailureCode.BadInput, path, -1, "attributes", "a position of three int32",
                    m_attributes.Count == 0 ? "none at all" : string.Join(", ", m_attributes.ConvertAll(a => a.Name)));
            RecordBytes = (int)bytes;
            Schema = new PointSchema(columns);
        }

        public IReadOnlyList<PotreeAttribute> Attributes => m_attributes;

        public PotreeAttribute Position { get; }

        public int RecordBytes { get; }

        public PointSchema Schema { get; }

        /// <summary>Index of the attribute that a column belongs to.</summary>
        /// <exception cref="ArgumentException">The cloud has no such column, or has it in another type.</exception>
        public int AttributeOf(PointAttribute column) =>
            m_attributeOfColumn.TryGetValue(column.Name, out int index) && Schema[Schema.IndexOf(column.Name)].Type == column.Type
                ? index
                : throw new ArgumentException("the cloud has no attribute " + column);

        /// <summary>The location of a column's value in a record; for a normal in two bytes, of these.</summary>
        public LasField FieldOf(string column) => m_fieldOfColumn[column];

        PointAttribute AddColumn(PotreeAttribute attribute, int index)
        {
            var column = attribute.Columns[index];
            // Two attributes may have one name; columns are found by name, so a later one is numbered.
            string name = column.Name;
            for (int number = 2; m_fieldOfColumn.ContainsKey(name); number++)
                name = column.Name + " (" + NumberText.Of(number) + ")";
            if (name != column.Name)
                attribute.Columns[index] = column = new PointAttribute(name, column.Type, column.Scale, column.Offset);
            int offset = attribute.RecordOffset + (attribute.IsPackedNormal ? 0 : index * column.Type.SizeOf());
            m_fieldOfColumn.Add(name, new LasField(name, column.Type, offset, column.Scale, column.Offset));
            m_attributeOfColumn.Add(name, m_attributes.Count);
            return column;
        }
    }
}
