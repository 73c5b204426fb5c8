namespace FastPoints.Store
{
    internal unsafe struct ColumnUnpacker
    {
        public PlaneView View;
        public int Column;
        public StoredColumn Stored;

        public void Unpack(int block, int first, int count, byte* to)
        {
            ulong divisor = (ulong)Stored.Divisor;
            int size = Stored.Type.SizeOf();
            if (View.Shape.IsWide(Column))
            {
                ulong* wide = stackalloc ulong[PlaneShape.MaxPointsPerBlock];
                View.UnpackWide(block, Column, first, count, wide);
                for (int i = 0; i < count; i++)
                    OrderedBits.Store(wide[i] * divisor, Stored.Type, to + i * size);
                return;
            }
            uint* values = stackalloc uint[PlaneShape.MaxPointsPerBlock];
            View.Unpack(block, Column, values);
            values += first;
            if (Stored.Type == AttributeType.UInt8)
                for (int i = 0; i < count; i++)
                    to[i] = (byte)values[i];
            else if (Stored.Type == AttributeType.UInt16)
                for (int i = 0; i < count; i++)
                    ((ushort*)to)[i] = (ushort)(values[i] * (uint)divisor);
            else
                for (int i = 0; i < count; i++)
                    OrderedBits.Store(values[i] * divisor, Stored.Type, to + i * size);
        }
    }
}
