namespace FastPoints.Cli.Preview;

/// <summary>Some of a batch's points: the first one of each cell before all others, so that no cell is empty for which there
/// is a point.</summary>
public static class CellThinning
{
    const int BatchLength = ColumnValues.BatchLength;
    const double CellsPerRootOfPoints = 1.05;

    public static unsafe PointBatch Thin(PointBatch points, PositionTransform transform, DisplayRanges ranges, int wanted)
    {
        var size = ranges.Robust.Size;
        double edge = Math.Max(size.x, Math.Max(size.y, size.z));
        double cellsPerUnit = edge > 0 ? CellsPerRootOfPoints * Math.Sqrt(wanted) / edge : 0;
        var cells = new CellHashing { Corner = ranges.Robust.Min, CellsPerUnit = cellsPerUnit };
        var isFirst = new bool[points.Count];
        int firsts = 0;
        double* x = stackalloc double[BatchLength], y = stackalloc double[BatchLength], z = stackalloc double[BatchLength];
        byte* bytes = (byte*)points.Bytes.GetUnsafeReadOnlyPtr();
        var positions = PositionColumns.Of(points);
        fixed (ulong* table = new ulong[CellHashing.Words])
        {
            for (int first = 0; first < points.Count; first += BatchLength)
            {
                int length = Math.Min(BatchLength, points.Count - first);
                positions.Load(bytes, first, length, x, y, z);
                transform.ToGeo(length, x, y, z);
                for (int i = 0; i < length; i++)
                    if (PositionBounds.IsFinite(x[i], y[i], z[i]) && cells.Mark(table, x[i], y[i], z[i]))
                    {
                        isFirst[first + i] = true;
                        firsts++;
                    }
            }
        }
        return Copy(points, Choose(isFirst, firsts, Math.Min(wanted, points.Count)));
    }

    static List<int> Choose(bool[] isFirst, int firsts, int wanted)
    {
        long fromFirsts = Math.Min(firsts, wanted), fromOthers = wanted - fromFirsts, others = isFirst.Length - firsts;
        long atFirst = 0, atOther = 0;
        var chosen = new List<int>(wanted);
        for (int i = 0; i < isFirst.Length; i++)
        {
            bool isChosen = isFirst[i] ? IsOneOf(atFirst++, firsts, fromFirsts) : IsOneOf(atOther++, others, fromOthers);
            if (isChosen)
                chosen.Add(i);
        }
        return chosen;
    }

    static bool IsOneOf(long index, long all, long wanted) => (index + 1) * wanted / all > index * wanted / all;

    static unsafe PointBatch Copy(PointBatch points, List<int> chosen)
    {
        var copy = new PointBatch(points.Schema, Math.Max(1, chosen.Count), Allocator.Persistent) { Count = chosen.Count };
        for (int column = 0; column < points.Schema.Count; column++)
        {
            int size = points.Column(column).Type.SizeOf();
            byte* from = (byte*)points.Bytes.GetUnsafeReadOnlyPtr() + points.Column(column).OffsetBytes;
            byte* to = (byte*)copy.Bytes.GetUnsafePtr() + copy.Column(column).OffsetBytes;
            for (int i = 0; i < chosen.Count; i++)
                UnsafeUtility.MemCpy(to + (long)i * size, from + (long)chosen[i] * size, size);
        }
        return copy;
    }
}
