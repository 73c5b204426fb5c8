using System.Collections.Generic;
using FastPoints.Core;

namespace FastPoints.Ply
{
    /// <summary>Turns an element's declaration into the steps that jobs take through each of its instances.</summary>
    static class PlyPlan
    {
        /// <summary>The steps that only find the end of an instance.</summary>
        public static List<PlyStep> Passing(PlyElement element) => Build(element, null, null);

        /// <summary>The steps that fill the batch's columns and skip all other properties.</summary>
        /// <param name="names">Attribute name of each property.</param>
        public static List<PlyStep> Decoding(PlyElement element, string[] names, PointBatch batch) =>
            Build(element, names, batch);

        /// <summary>The attributes of a packed colour.</summary>
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
        /// <summary>Values that are not wanted.</summary>
        Skip,
        /// <summary>A value that goes into a column.</summary>
        Value,
        /// <summary>A list, which is skipped.</summary>
        List,
        /// <summary>In text: a number whose bits are a colour.</summary>
        Color,
    }

    /// <summary>One step through one instance of an element. Blittable: jobs carry arrays of these.</summary>
    struct PlyStep
    {
        public PlyStepKind Kind;

        /// <summary>Type of the value, or of a list's count.</summary>
        public AttributeType Type;

        /// <summary>Skip: number of values. List: bytes of an item.</summary>
        public int Count;

        /// <summary>In a binary file: bytes of the skipped values, of the value, or of a list's count.</summary>
        public int Bytes;

        /// <summary>Value: offset of its column in the batch. Colour: of red, or -1.</summary>
        public int ColumnOffsetBytes;
        public int GreenOffsetBytes;
        public int BlueOffsetBytes;
        public int AlphaOffsetBytes;
    }
}
