using System;
using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Reading;

namespace FastPoints.Octrees
{
    sealed class PotreeLayout
    {
        // Longer records than any cloud has.
        const int MaxRecordBytes = 1 << 14;

        readonly List<PotreeAttribute> m_attributes = new List<PotreeAttribute>();
        readonly PointFields m_fields = new PointFields();

        readonly List<int> m_attributeOfField = new List<int>();

        public PotreeLayout(IEnumerable<PotreeAttribute> attributes, string path)
        {
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
                    AddField(attribute, i);
                m_attributes.Add(attribute);
                if (attribute.IsPosition && Position == null)
                    Position = attribute;
            }
            if (Position == null)
                throw PointCloudException.Wanted(FailureCode.BadInput, path, -1, "attributes", "a position of three int32",
                    m_attributes.Count == 0 ? "none at all" : string.Join(", ", m_attributes.ConvertAll(a => a.Name)));
            RecordBytes = (int)bytes;
            Schema = m_fields.ToSchema();
        }

        public IReadOnlyList<PotreeAttribute> Attributes => m_attributes;

        public PotreeAttribute Position { get; }

        public int RecordBytes { get; }

        public PointSchema Schema { get; }

        public int AttributeOf(PointAttribute column) => m_attributeOfField[m_fields.IndexOf(column)];

        // For a normal in two bytes, of these.
        public PointField FieldOf(PointAttribute column) => m_fields[m_fields.IndexOf(column)];

        // recordStart: offset in the cloud's record at which the records begin.
        public FieldCopy[] PlanCopies(PointBatch batch, Func<PotreeAttribute, bool> isTaken, int recordStart)
        {
            var fields = new List<PointField>();
            var columns = new List<PointColumn>();
            for (int i = 0; i < batch.Schema.Count; i++)
            {
                if (!isTaken(m_attributes[AttributeOf(batch.Schema[i])]))
                    continue;
                var field = FieldOf(batch.Schema[i]);
                field.ByteOffset -= recordStart;
                fields.Add(field);
                columns.Add(batch.Column(i));
            }
            return FieldCopyPlan.Make(fields.ToArray(), columns.ToArray());
        }

        void AddField(PotreeAttribute attribute, int index)
        {
            var column = attribute.Columns[index];
            int offset = attribute.RecordOffset + (attribute.IsPackedNormal ? 0 : index * column.Type.SizeOf());
            var field = m_fields.Add(new PointField(column.Name, column.Type, offset, column.Scale, column.Offset));
            m_attributeOfField.Add(m_attributes.Count);
            attribute.Columns[index] = field.ToAttribute();
        }
    }
}
