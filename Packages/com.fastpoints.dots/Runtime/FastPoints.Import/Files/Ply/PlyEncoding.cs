namespace FastPoints.Files
{
    /// <summary>How a PLY file writes its values.</summary>
    public enum PlyEncoding
    {
        Ascii,
        BinaryLittleEndian,
        BinaryBigEndian,
    }
}
