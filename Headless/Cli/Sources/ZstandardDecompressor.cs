namespace FastPoints.Cli.Sources;

/// <summary>Zstandard (RFC 8878) by the system's libzstd, which Debian, Fedora and others have always installed: .NET has no
/// decoder of its own before version 11. The package knows it by <see cref="Decompressors.Zstandard"/> only.</summary>
internal sealed unsafe class ZstandardDecompressor : StreamDecompressor
{
    private const int MaxWindowLog = 25; // A frame that wants more memory (32 MiB) is refused: its header may claim anything.

    private const int ResetSessionOnly = 1;
    private const int WindowLogMax = 100;

    private static readonly string[] s_names =
    {
        "libzstd.so.1", "libzstd.so", "libzstd.1.dylib", "libzstd.dylib", "libzstd.dll", "zstd.dll",
    };

    private readonly Library m_library;
    private nint m_context;

    private ZstandardDecompressor(Library library)
    {
        m_library = library;
        m_context = library.CreateContext();
    }

    public static void Register()
    {
        if (Decompressors.Zstandard != null)
            return;
        foreach (string name in s_names)
        {
            // One that lacks a function is too old.
            if (!NativeLibrary.TryLoad(name, out nint handle)
                || !NativeLibrary.TryGetExport(handle, "ZSTD_DCtx_setParameter", out _))
                continue;
            var library = new Library(handle);
            Decompressors.Zstandard = () => new ZstandardDecompressor(library);
            return;
        }
    }

    public override void Start()
    {
        m_library.Reset(m_context, ResetSessionOnly);
        m_library.SetParameter(m_context, WindowLogMax, MaxWindowLog);
    }

    public override bool Decode(ReadOnlySpan<byte> input, Span<byte> output, out int consumed, out int written)
    {
        fixed (byte* from = input)
        fixed (byte* to = output)
        {
            var source = new Piece { Start = from, Bytes = (nuint)input.Length };
            var target = new Piece { Start = to, Bytes = (nuint)output.Length };
            bool isValid = true, isMoving = true;
            while (isValid && isMoving && target.Done < target.Bytes)
            {
                nuint before = source.Done + target.Done;
                isValid = m_library.IsError(m_library.Decompress(m_context, &target, &source)) == 0;
                isMoving = source.Done + target.Done > before;
            }
            consumed = (int)source.Done;
            written = (int)target.Done;
            return isValid;
        }
    }

    public override void Dispose()
    {
        if (m_context != 0)
            m_library.FreeContext(m_context);
        m_context = 0;
    }

    private struct Piece
    {
        public byte* Start;
        public nuint Bytes;
        public nuint Done;
    }

    /// <summary>The functions of zstd.h (1.4 and later) that it takes.</summary>
    private sealed class Library(nint handle)
    {
        public readonly delegate* unmanaged<nint> CreateContext = (delegate* unmanaged<nint>)Find(handle, "ZSTD_createDCtx");
        public readonly delegate* unmanaged<nint, nuint> FreeContext =
            (delegate* unmanaged<nint, nuint>)Find(handle, "ZSTD_freeDCtx");
        public readonly delegate* unmanaged<nint, int, nuint> Reset =
            (delegate* unmanaged<nint, int, nuint>)Find(handle, "ZSTD_DCtx_reset");
        public readonly delegate* unmanaged<nint, int, int, nuint> SetParameter =
            (delegate* unmanaged<nint, int, int, nuint>)Find(handle, "ZSTD_DCtx_setParameter");
        public readonly delegate* unmanaged<nint, Piece*, Piece*, nuint> Decompress =
            (delegate* unmanaged<nint, Piece*, Piece*, nuint>)Find(handle, "ZSTD_decompressStream");
        public readonly delegate* unmanaged<nuint, uint> IsError = (delegate* unmanaged<nuint, uint>)Find(handle, "ZSTD_isError");

        private static nint Find(nint handle, string name) => NativeLibrary.GetExport(handle, name);
    }
}
