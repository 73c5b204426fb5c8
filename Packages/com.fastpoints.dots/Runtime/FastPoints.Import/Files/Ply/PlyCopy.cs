using System.Collections.Generic;

namespace FastPoints.Files
{
    /// <summary>One to three values of equal width that lie side by side in a record (x, y, z; red, green, blue), to be copied
    /// into their columns in one pass. Blittable: jobs carry arrays of these.</summary>
    struct PlyCopy
    {
        public int SourceBytes;
        public int ValueBytes;
        public int Values;
        public int Column0;
        public int Column1;
        public int Column2;

        public static List<PlyCopy> From(List<PlyStep> steps)
        {
            var copies = new List<PlyCopy>();
            int source = 0;
            bool isAdjacent = false;
            foreach (var step in steps)
            {
                if (step.Kind == PlyStepKind.Value)
                {
                    int last = copies.Count - 1;
                    if (isAdjacent && copies[last].ValueBytes == step.Bytes && copies[last].Values < 3)
                    {
                        var longer = copies[last];
                        longer.Add(step.ColumnOffsetBytes);
                        copies[last] = longer;
                    }
                    else
                    {
                        var copy = new PlyCopy { SourceBytes = source, ValueBytes = step.Bytes };
                        copy.Add(step.ColumnOffsetBytes);
                        copies.Add(copy);
                    }
                }
                isAdjacent = step.Kind == PlyStepKind.Value;
                source += step.Bytes;
            }
            return copies;
        }

        void Add(int column)
        {
            if (Values == 0)
                Column0 = column;
            else if (Values == 1)
                Column1 = column;
            else
                Column2 = column;
            Values++;
        }
    }
}
