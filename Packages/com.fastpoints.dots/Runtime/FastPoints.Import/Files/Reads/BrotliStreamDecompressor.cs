using System;
using System.Buffers;
using System.IO.Compression;

namespace FastPoints.Files
{
    /// <summary>Brotli (RFC 7932) by the framework's own decoder, which allocates nothing once it has started.</summary>
    public sealed class BrotliStreamDecompressor : StreamDecompressor
    {
        BrotliDecoder m_decoder;

        public override void Start()
        {
            m_decoder.Dispose();
            m_decoder = default;
        }

        public override bool Decode(ReadOnlySpan<byte> input, Span<byte> output, out int consumed, out int written)
        {
            consumed = written = 0;
            while (written < output.Length)
            {
                var status = m_decoder.Decompress(input.Slice(consumed), output.Slice(written), out int taken, out int made);
                consumed += taken;
                written += made;
                if (status == OperationStatus.InvalidData)
                    return false;
                if (status != OperationStatus.DestinationTooSmall || taken == 0 && made == 0)
                    break;
            }
            return true;
        }

        public override void Dispose() => m_decoder.Dispose();
    }
}
