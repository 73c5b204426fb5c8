namespace FastPoints.Sampling
{
    /// <summary>Moves values of one column to another of the same type, by their size.</summary>
    static unsafe class ColumnCopy
    {
        /// <summary>to[toIndex[i]] = from[fromIndex[i]].</summary>
        public static void Scatter(byte* from, byte* to, int size, int* fromIndex, int* toIndex, int count)
        {
            switch (size)
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
