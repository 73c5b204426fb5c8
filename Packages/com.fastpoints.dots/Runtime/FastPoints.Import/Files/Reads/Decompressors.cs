using System;

namespace FastPoints.Files
{
    /// <summary>
    /// Who undoes the general compression that some formats put around their points. A project registers its own where the
    /// framework brings none, or a faster one, before it opens a source.
    /// </summary>
    /// <remarks>
    /// The framework decodes Brotli in .NET, in Unity's editor and in players of both scripting backends: Mono ships the native
    /// decoder since .NET Standard 2.1 (on Android since the fix of UUM-73753, in all 6000.x), IL2CPP links it in. Where it is
    /// missing a read fails and names <see cref="Brotli"/>. For zstandard .NET Standard 2.1 has nothing.
    /// </remarks>
    public static class Decompressors
    {
        /// <summary>Makes a decompressor of Brotli streams (Potree 2.0 of encoding BROTLI).</summary>
        public static Func<StreamDecompressor> Brotli { get; set; } = () => new BrotliStreamDecompressor();

        /// <summary>Makes a decompressor of zstandard frames (EPT of data type zstandard), or null.</summary>
        public static Func<StreamDecompressor> Zstandard { get; set; }
    }
}
