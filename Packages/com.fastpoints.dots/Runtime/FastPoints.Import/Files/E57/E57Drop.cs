namespace FastPoints.Files
{
    /// <summary>Why a point is left out.</summary>
    static class E57Drop
    {
        public const byte Invalid = 1;
        public const byte Damaged = 2;
    }
}
