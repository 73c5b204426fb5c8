using System;

namespace FastPoints.Files
{
    /// <summary>
    /// Undoes one kind of general compression (Brotli, zstandard), one stream after the other, each piece by piece, so that a
    /// long stream is done in slices. Called by jobs on any thread, but by one at a time.
    /// </summary>
    public abstract class StreamDecompressor : IDisposable
    {
        /// <summary>Forgets what came before: the next bytes begin a stream.</summary>
        public abstract void Start();

        /// <summary>Decodes as much as fits into <paramref name="output"/>.</summary>
        /// <param name="input">The rest of the stream; bytes that were consumed do not come again.</param>
        /// <param name="consumed">Bytes of the input that are done with.</param>
        /// <param name="written">Bytes of the output; fewer than fit only where the stream has ended or is broken.</param>
        /// <returns>False where the stream is broken.</returns>
        public abstract bool Decode(ReadOnlySpan<byte> input, Span<byte> output, out int consumed, out int written);

        public abstract void Dispose();
    }
}
