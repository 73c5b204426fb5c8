namespace FastPoints.Files
{
    /// <summary>What a range had besides points. Written by jobs, told on the main thread.</summary>
    struct E57Oddities
    {
        /// <summary>Points left out since their scan marks them as invalid.</summary>
        public int Invalid;

        /// <summary>Points left out since a page that holds some of them has a wrong checksum.</summary>
        public int Damaged;
        public int DamagedPages;
        public long FirstDamagedPage;

        /// <summary>Integers above the maximum that their field has: it was taken.</summary>
        public int Misfits;
    }
}
