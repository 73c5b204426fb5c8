using System;

namespace FastPoints.Files
{
    /// <summary>Where the decoding of a block stands, to go on from without its beginning: see <see cref="BlockRead.KeepState"/>.
    /// Any slot of the same reader and the same attributes may go on from it. Whoever asked for it
    /// disposes of it.</summary>
    public abstract class DecoderState : IDisposable
    {
        /// <summary>Memory that it takes.</summary>
        public abstract long Bytes { get; }

        public abstract void Dispose();
    }
}
