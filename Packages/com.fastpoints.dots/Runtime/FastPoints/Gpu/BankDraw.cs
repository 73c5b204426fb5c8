namespace FastPoints.Gpu
{
    /// <summary>The blocks of one bank of the pool: one draw.</summary>
    public struct BankDraw
    {
        public int Bank;
        public int FirstInstance;

        /// <summary>Blocks of up to 128 points.</summary>
        public int InstanceCount;
    }
}
