namespace FastPoints.Files
{
    /// <summary>Where a walk through the packets of one scan stands.</summary>
    struct E57WalkState
    {
        /// <summary>Logical offset of the next packet.</summary>
        public long Position;

        /// <summary>Streams that have not all their bytes yet.</summary>
        public int StreamsLeft;

        /// <summary>Data packets in this step, and the length of the last one.</summary>
        public int Packets;
        public int LastPacketBytes;

        /// <summary>An <see cref="E57Error"/>, at <see cref="Position"/>.</summary>
        public int Error;

        /// <summary>Headers whose page has a wrong checksum, and the first such page.</summary>
        public int DamagedHeaders;
        public long FirstDamagedPage;

        public bool IsDone => StreamsLeft == 0 || Error != E57Error.None;
    }
}
