namespace FastPoints.Files
{
    /// <summary>Where the decoding of a block stands, to go on from without its beginning: see <see cref="BlockRead.KeepState"/>.
    /// Any slot of the same reader and the same attributes may go on from it.</summary>
    public abstract class DecoderState
    {
        /// <summary>Memory that it takes.</summary>
        public abstract long Bytes { get; }
    }
}
