using Unity.Collections;

namespace FastPoints.Sampling
{
    /// <summary>Copies points from one batch to another of the same attributes: values by their size, whatever
    /// their type.</summary>
    unsafe struct ColumnCopy
    {
        public byte* From;
        public byte* To;
        public NativeArray<PointColumn> ColumnsOfSource;
        public NativeArray<PointColumn> ColumnsOfTarget;

        /// <summary>Point toIndex[i] becomes point fromIndex[i]. A batch may be its own target if points only ever move down, and
        /// in order.</summary>
        public void Scatter(int* fromIndex, int* toIndex, int count)
        {
            for (int column = 0; count > 0 && column < ColumnsOfTarget.Length; column++)
            {
                byte* from = From + ColumnsOfSource[column].OffsetBytes, to = To + ColumnsOfTarget[column].OffsetBytes;
                switch (ColumnsOfTarget[column].Type.SizeOf())
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
