using System.Collections.Generic;
using FastPoints.Points;

namespace FastPoints.Files
{
    /// <summary>Turns an element's declaration into the steps that jobs take through each of its instances.</summary>
    static class PlyPlan
    {
        /// <summary>Steps that only find the end of an instance.</summary>
        public static List<PlyStep> Passing(PlyElement element) => Build(element, null, null);

        /// <summary>Steps that fill the batch's columns and pass over all other properties.</summary>
        /// <param name="names">Attribute name of each property.</param>
        public static List<PlyStep> Decoding(PlyElement element, string[] names, PointBatch batch) =>
            Build(element, names, batch);

        static List<PlyStep> Build(PlyElement element, string[] names, PointBatch batch)
        {
            var steps = new List<PlyStep>();
            for (int i = 0; i < element.Properties.Count; i++)
            {
                var property = element.Properties[i];
                int column = batch == null || property.IsList ? -1 : batch.Schema.IndexOf(names[i]);
                if (property.IsList)
                {
                    steps.Add(new PlyStep
                    {
                        Kind = PlyStepKind.List,
                        Type = property.CountType,
                        Bytes = property.CountType.SizeOf(),
                        Count = property.Type.SizeOf(),
                    });
                }
                else if (column >= 0)
                {
                    steps.Add(new PlyStep
                    {
                        Kind = PlyStepKind.Value,
                        Type = property.Type,
                        Bytes = property.Type.SizeOf(),
                        Count = 1,
                        ColumnOffsetBytes = batch.Column(column).OffsetBytes,
                    });
                }
                else
                {
                    var skip = new PlyStep { Kind = PlyStepKind.Skip };
                    int last = steps.Count - 1;
                    if (last >= 0 && steps[last].Kind == PlyStepKind.Skip)
                    {
                        skip = steps[last];
                        steps.RemoveAt(last);
                    }
                    skip.Count++;
                    skip.Bytes += property.Type.SizeOf();
                    steps.Add(skip);
                }
            }
            return steps;
        }
    }

    enum PlyStepKind : byte
    {
        /// <summary>Values that nobody asked for.</summary>
        Skip,
        /// <summary>A value that goes into a column.</summary>
        Value,
        /// <summary>A list, passed over.</summary>
        List,
    }

    /// <summary>One step through one instance of an element. Blittable: jobs carry arrays of these.</summary>
    struct PlyStep
    {
        public PlyStepKind Kind;

        /// <summary>Of the value, or of a list's count.</summary>
        public AttributeType Type;

        /// <summary>Skip: values. List: bytes of an item.</summary>
        public int Count;

        /// <summary>In a binary file: of the skipped values, of the value, of a list's count.</summary>
        public int Bytes;

        /// <summary>Value: where its column starts in the batch.</summary>
        public int ColumnOffsetBytes;
    }
}
