using System.Collections.Generic;
using FastPoints.Core;

namespace FastPoints.Ply
{
    static class PlyPlan
    {
        public static List<PlyStep> Passing(PlyElement element) => Build(element, null, null);

        public static List<PlyStep> Decoding(PlyElement element, string[] names, PointBatch batch) =>
            Build(element, names, batch);

        public static readonly string[] ColorNames =
        {
            AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue, AttributeNames.Alpha,
        };

        static PlyStep ColorStep(PlyProperty property, PointBatch batch)
        {
            int Offset(int i)
            {
                int column = i == 3 && !property.HasAlpha ? -1 : batch.Schema.IndexOf(ColorNames[i]);
                return column < 0 ? -1 : batch.Column(column).OffsetBytes;
            }
            return new PlyStep
            {
                Kind = PlyStepKind.Color,
                Type = property.Type,
                Bytes = property.Type.SizeOf(),
                Count = 1,
                ColumnOffsetBytes = Offset(0),
                GreenOffsetBytes = Offset(1),
                BlueOffsetBytes = Offset(2),
                AlphaOffsetBytes = Offset(3),
            };
        }

        static List<PlyStep> Build(PlyElement element, string[] names, PointBatch batch)
        {
            var steps = new List<PlyStep>();
            for (int i = 0; i < element.Properties.Count; i++)
            {
                var property = element.Properties[i];
                if (property.IsColor && batch != null)
                {
                    steps.Add(ColorStep(property, batch));
                    continue;
                }
                int column = batch == null || property.IsList || names[i] == null ? -1 : batch.Schema.IndexOf(names[i]);
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
        Skip,
        Value,
        List,
        // In text: a number whose bits are a colour.
        Color,
    }

    // One step through one instance of an element. Blittable: jobs carry arrays of these.
    struct PlyStep
    {
        public PlyStepKind Kind;
        public AttributeType Type;

        // Skip: number of values. List: bytes of an item.
        public int Count;

        // In a binary file: bytes of the skipped values, of the value, or of a list's count.
        public int Bytes;

        // Value: offset of its column in the batch. Colour: of red, or -1.
        public int ColumnOffsetBytes;
        public int GreenOffsetBytes;
        public int BlueOffsetBytes;
        public int AlphaOffsetBytes;
    }
}
