using System.IO.Compression;

namespace UnityOutside.Images;

/// <summary>Reads and writes pictures as PNG files: 8-bit RGB (RGBA if not opaque), marked as sRGB. Also reads 8-bit grey
/// ones; any other kind is refused with a reason.</summary>
public static class PngCodec
{
    static readonly byte[] s_signature = { 0x89, (byte)'P', (byte)'N', (byte)'G', 0x0D, 0x0A, 0x1A, 0x0A };

    const int ColorGray = 0, ColorRgb = 2, ColorGrayAlpha = 4, ColorRgba = 6;
    const int ChunkOverheadBytes = 12;
    const int MaxEdgePx = 16384;
    const long MaxInflation = 1032; // Deflate expands one byte to 1,032 at most: a small file cannot claim a large picture.

    /// <param name="rgba">Row by row from the top, as are all pixels here.</param>
    public static byte[] Encode(byte[] rgba, int width, int height)
    {
        bool isOpaque = true;
        for (int i = 3; i < rgba.Length && isOpaque; i += 4)
            isOpaque = rgba[i] == 255;
        using var file = new MemoryStream();
        WriteHeader(file, width, height, isOpaque);
        WriteChunk(file, "IDAT", Compress(rgba, width, height, isOpaque));
        WriteChunk(file, "IEND", Array.Empty<byte>());
        return file.ToArray();
    }

    /// <summary>Writes the signature and the chunks before the pixels.</summary>
    public static void WriteHeader(Stream file, int width, int height, bool isOpaque)
    {
        file.Write(s_signature, 0, s_signature.Length);
        byte[] header = new byte[13];
        WriteBigEndian(header, 0, (uint)width);
        WriteBigEndian(header, 4, (uint)height);
        header[8] = 8;
        header[9] = (byte)(isOpaque ? ColorRgb : ColorRgba);
        WriteChunk(file, "IHDR", header);
        WriteChunk(file, "sRGB", new byte[] { 0 });
        WriteChunk(file, "tEXt", Encoding.ASCII.GetBytes("Software\0FastPoints"));
    }

    /// <summary>The pixels for IDAT; of an opaque picture without alpha.</summary>
    public static byte[] Compress(byte[] rgba, int width, int height, bool isOpaque) => isOpaque
        ? Zlib(FilteredRows(WithoutAlpha(rgba), width * 3, height, 3))
        : Zlib(FilteredRows(rgba, width * 4, height, 4));

    /// <exception cref="PngException">It is no valid PNG, or of a kind that is not supported.</exception>
    public static byte[] Decode(byte[] file, out int width, out int height)
    {
        for (int i = 0; i < s_signature.Length; i++)
            if (i >= file.Length || file[i] != s_signature[i])
                throw new PngException(PngFailure.BadInput, i, "no PNG signature");

        using var data = new MemoryStream();
        width = height = 0;
        int color = -1;
        bool ended = false;
        long at = s_signature.Length;
        while (!ended)
        {
            if (at + ChunkOverheadBytes > file.Length)
                throw new PngException(PngFailure.Truncated, at, "the picture ends before its IEND chunk");
            uint length = ReadBig(file, at);
            if (length > file.Length - at - ChunkOverheadBytes)
                throw PngException.Wanted(PngFailure.Truncated, at, "chunk length",
                    "at most " + (file.Length - at - ChunkOverheadBytes), length);
            int content = (int)at + 8;
            string name = Encoding.ASCII.GetString(file, (int)at + 4, 4);
            uint crc = PngChecksums.Crc32(file, (int)at + 4, (int)length + 4);
            if (crc != ReadBig(file, content + length))
                throw PngException.Wanted(PngFailure.BadInput, content + length, "checksum of chunk " + name,
                    crc.ToString("x8"), ReadBig(file, content + length).ToString("x8"));
            if (name == "IHDR")
                ReadHeader(file, content, (int)length, out width, out height, out color);
            else if (name == "IDAT")
                data.Write(file, content, (int)length);
            ended = name == "IEND";
            at += ChunkOverheadBytes + length;
        }
        if (color < 0)
            throw new PngException(PngFailure.BadInput, s_signature.Length, "the picture has no IHDR chunk");

        int pixelBytes = ChannelsOf(color);
        byte[] rows = Unzlib(data.ToArray(), (width * pixelBytes + 1) * (long)height);
        var rgba = new byte[width * height * 4];
        for (int y = 0; y < height; y++)
        {
            if (!PngFilters.Decode(rows, y, width * pixelBytes, pixelBytes))
                throw new PngException(PngFailure.BadInput, -1, "row " + y + " has an unknown filter");
            ExpandRow(rows, y * (width * pixelBytes + 1) + 1, color, rgba, y * width * 4, width);
        }
        return rgba;
    }

    static int ChannelsOf(int color) => color == ColorGray ? 1 : color == ColorGrayAlpha ? 2 : color == ColorRgb ? 3 : 4;

    static void ReadHeader(byte[] file, int at, int length, out int width, out int height, out int color)
    {
        if (length != 13)
            throw PngException.Wanted(PngFailure.BadInput, at, "length of IHDR", 13, length);
        uint claimedWidth = ReadBig(file, at), claimedHeight = ReadBig(file, at + 4);
        color = file[at + 9];
        if (claimedWidth == 0 || claimedHeight == 0 || claimedWidth > MaxEdgePx ||
            claimedHeight > MaxEdgePx)
            throw PngException.Wanted(PngFailure.Unsupported, at, "size of the picture",
                "edges of 1 to " + MaxEdgePx, claimedWidth + "x" + claimedHeight);
        if (file[at + 8] != 8)
            throw PngException.Wanted(PngFailure.Unsupported, at + 8, "bits of a channel", 8, file[at + 8]);
        if (color != ColorGray && color != ColorRgb && color != ColorGrayAlpha && color != ColorRgba)
            throw PngException.Wanted(PngFailure.Unsupported, at + 9, "colour type", "0, 2, 4 or 6", color);
        if (file[at + 10] != 0 || file[at + 11] != 0)
            throw PngException.Wanted(PngFailure.BadInput, at + 10, "compression and filter method", "0 and 0",
                file[at + 10] + " and " + file[at + 11]);
        if (file[at + 12] != 0)
            throw PngException.Wanted(PngFailure.Unsupported, at + 12, "interlacing", 0, file[at + 12]);
        width = (int)claimedWidth;
        height = (int)claimedHeight;
        if ((long)width * height * 4 > int.MaxValue / 2)
            throw new PngException(PngFailure.Unsupported, at, "a picture of more than 1 GiB is not read");
    }

    static void ExpandRow(byte[] row, int from, int color, byte[] rgba, int to, int width)
    {
        bool gray = color == ColorGray || color == ColorGrayAlpha;
        bool alpha = color == ColorGrayAlpha || color == ColorRgba;
        for (int x = 0; x < width; x++)
        {
            rgba[to] = row[from];
            rgba[to + 1] = row[gray ? from : from + 1];
            rgba[to + 2] = row[gray ? from : from + 2];
            from += gray ? 1 : 3;
            rgba[to + 3] = alpha ? row[from++] : (byte)255;
            to += 4;
        }
    }

    static byte[] WithoutAlpha(byte[] rgba)
    {
        var rgb = new byte[rgba.Length / 4 * 3];
        for (int from = 0, to = 0; from < rgba.Length; from += 4, to += 3)
        {
            rgb[to] = rgba[from];
            rgb[to + 1] = rgba[from + 1];
            rgb[to + 2] = rgba[from + 2];
        }
        return rgb;
    }

    static byte[] FilteredRows(byte[] pixels, int rowBytes, int height, int pixelBytes)
    {
        var rows = new byte[(rowBytes + 1) * height];
        for (int y = 0; y < height; y++)
            PngFilters.Encode(pixels, y, rowBytes, pixelBytes, rows, y * (rowBytes + 1));
        return rows;
    }

    /// <summary>A zlib stream (RFC 1950) around a deflate stream: 32 KiB window, no dictionary, Adler-32 at the
    /// end.</summary>
    static byte[] Zlib(byte[] bytes)
    {
        using var stream = new MemoryStream();
        stream.WriteByte(0x78);
        stream.WriteByte(0x9C);
        using (var deflate = new DeflateStream(stream, CompressionLevel.Optimal, true))
            deflate.Write(bytes, 0, bytes.Length);
        byte[] adler = new byte[4];
        WriteBigEndian(adler, 0, PngChecksums.Adler32(bytes, 0, bytes.Length));
        stream.Write(adler, 0, adler.Length);
        return stream.ToArray();
    }

    static byte[] Unzlib(byte[] zlib, long length)
    {
        const int HeaderBytes = 2, TrailerBytes = 4;
        if (zlib.Length < HeaderBytes + TrailerBytes || (zlib[0] & 15) != 8 || (zlib[0] << 8 | zlib[1]) % 31 != 0 ||
            (zlib[1] & 32) != 0)
            throw new PngException(PngFailure.BadInput, -1, "the pixels are no zlib stream");
        if (length > zlib.LongLength * MaxInflation)
            throw PngException.Wanted(PngFailure.Truncated, -1, "compressed bytes for so large a picture",
                "at least " + length / MaxInflation, zlib.Length);
        var bytes = new byte[length];
        int read = 0;
        try
        {
            using var stream = new MemoryStream(zlib, HeaderBytes, zlib.Length - HeaderBytes - TrailerBytes);
            using var inflate = new DeflateStream(stream, CompressionMode.Decompress);
            while (read < bytes.Length)
            {
                int more = inflate.Read(bytes, read, bytes.Length - read);
                if (more == 0)
                    break;
                read += more;
            }
        }
        catch (InvalidDataException failure)
        {
            throw new PngException(PngFailure.BadInput, -1, "the pixels are no deflate stream", failure);
        }
        if (read < bytes.Length)
            throw PngException.Wanted(PngFailure.Truncated, -1, "bytes of pixels", bytes.Length, read);
        uint adler = PngChecksums.Adler32(bytes, 0, bytes.Length), stored = ReadBig(zlib, zlib.Length - TrailerBytes);
        if (adler != stored)
            throw PngException.Wanted(PngFailure.BadInput, -1, "checksum of the pixels", adler.ToString("x8"),
                stored.ToString("x8"));
        return bytes;
    }

    public static void WriteChunk(Stream file, string name, byte[] content)
    {
        var chunk = new byte[content.Length + ChunkOverheadBytes];
        WriteBigEndian(chunk, 0, (uint)content.Length);
        for (int i = 0; i < 4; i++)
            chunk[4 + i] = (byte)name[i];
        Array.Copy(content, 0, chunk, 8, content.Length);
        WriteBigEndian(chunk, content.Length + 8, PngChecksums.Crc32(chunk, 4, content.Length + 4));
        file.Write(chunk, 0, chunk.Length);
    }

    public static void WriteBigEndian(byte[] to, int at, uint value)
    {
        to[at] = (byte)(value >> 24);
        to[at + 1] = (byte)(value >> 16);
        to[at + 2] = (byte)(value >> 8);
        to[at + 3] = (byte)value;
    }

    static uint ReadBig(byte[] from, long at) =>
        (uint)from[at] << 24 | (uint)from[at + 1] << 16 | (uint)from[at + 2] << 8 | from[at + 3];
}

public enum PngFailure { BadInput, Truncated, Unsupported }

/// <summary>What is wrong with a PNG file, at which byte (-1 for no single one).</summary>
public sealed class PngException : Exception
{
    public readonly PngFailure Failure;
    public readonly long ByteOffset;

    public PngException(PngFailure failure, long byteOffset, string what, Exception inner = null) : base(what, inner)
    {
        Failure = failure;
        ByteOffset = byteOffset;
    }

    public static PngException Wanted(PngFailure failure, long byteOffset, string field, object wanted, object got) =>
        new PngException(failure, byteOffset, FormattableString.Invariant($"{field}: wanted {wanted}, got {got}"));
}
