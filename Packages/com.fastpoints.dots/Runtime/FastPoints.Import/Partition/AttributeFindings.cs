namespace FastPoints.Partition
{
    /// <summary>What all values of one attribute showed. Blittable.</summary>
    public struct AttributeFindings
    {
        /// <summary>Smallest and largest as <see cref="Store.OrderedBits"/>.</summary>
        public ulong Min;
        public ulong Max;

        /// <summary>All values or-ed: trailing zeros are a power of two that divides every one.</summary>
        public ulong Or;

        /// <summary>0 where every value is a multiple of 257: eight bits twice.</summary>
        public uint NotDoubled;

        public static AttributeFindings None => new AttributeFindings { Min = ulong.MaxValue };

        public bool IsEmpty => Min > Max;

        public void Include(in AttributeFindings other)
        {
            Min = Min < other.Min ? Min : other.Min;
            Max = Max > other.Max ? Max : other.Max;
            Or |= other.Or;
            NotDoubled |= other.NotDoubled;
        }
    }
}
