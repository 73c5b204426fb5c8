using Unity.Collections;

namespace FastPoints.Sampling
{
    /// <summary>Moves points from one batch to another of the same attributes, by the size of their values.</summary>
    unsafe struct ColumnCopy
    {
        public byte* From;
        public byte* To;
        public NativeArray<PointColumn> ColumnsOfFrom;
        public NativeArray<PointColumn> ColumnsOfTo;

        /// <summary>Point toIndex[i] becomes point fromIndex[i]. A batch may be its own target if points only ever move down, and
        /// in order.</summary>
        public void Scatter(int* fromIndex, int* toIndex, int count)
        {
            for (int column = 0; count > 0 && column < ColumnsOfTo.Length; column++)
            {
                byte* from = From + ColumnsOfFrom[column].OffsetBytes, to = To + ColumnsOfTo[column].OffsetBytes;
                switch (ColumnsOfTo[column].Type.SizeOf())
                {
                    case 1:
                        for (int i = 0; i < count; i++)
                            to[toIndex[i]] = from[fromIndex[i]];
                        break;
                    case 2:
                        for (int i = 0; i < count; i++)
                            ((ushort*)to)[toIndex[i]] = ((ushort*)from)[fromIndex[i]];
                        break;
                    case 4:
                        for (int i = 0; i < count; i++)
                            ((uint*)to)[toIndex[i]] = ((uint*)from)[fromIndex[i]];
                        break;
                    default:
                        for (int i = 0; i < count; i++)
                            ((ulong*)to)[toIndex[i]] = ((ulong*)from)[fromIndex[i]];
                        break;
                }
            }
        }
    }
}
