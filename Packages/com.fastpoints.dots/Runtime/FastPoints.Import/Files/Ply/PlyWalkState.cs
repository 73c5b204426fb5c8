namespace FastPoints.Files
{
    /// <summary>An element to walk through. Blittable: jobs carry arrays of these.</summary>
    struct PlyWalkElement
    {
        public ulong Count;

        /// <summary>Bytes of one instance, or -1 where lists make it vary.</summary>
        public int FixedBytes;
        public int FirstStep;
        public int Steps;

        /// <summary>Whether its instances are the points, to be gathered into blocks.</summary>
        public bool IsIndexed;
    }

    /// <summary>How far a walk through a binary file's elements has come: it can stop at any step and go on there.</summary>
    struct PlyWalkState
    {
        /// <summary>Byte in the file at which the next step starts. It may lie behind what was read: lists are stepped
        /// over.</summary>
        public long Position;
        public int Element;
        public ulong Instance;
        public int Step;

        public long InstanceStart;
        public long BlockStart;
        public int BlockPoints;
        public long PointsInBlocks;

        public int Error;
        public long ErrorOffset;
        public bool IsDone;
    }
}
