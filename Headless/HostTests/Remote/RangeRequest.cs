using System.Buffers;

namespace FastPoints.HostTests.Remote;

sealed class RangeRequest
{
    readonly Dictionary<string, string> m_headers = new(StringComparer.OrdinalIgnoreCase);

    public string Method { get; private set; }

    public string Target { get; private set; } // With its query, as it came.

    // Of the file that is asked for.
    public string Name => Uri.UnescapeDataString(Regex.Replace(Target.Split('?')[0], "^/(redirected/)*", ""));

    public Fault Fault { get; set; } // That it was answered with.

    public string Header(string name) => m_headers.GetValueOrDefault(name);

    // The bytes that are asked for of a file so long: all of them without a range, none (-1) where the range has none.
    public bool TryRange(long length, out long from, out long bytes)
    {
        (from, bytes) = (0, length);
        Match range = Regex.Match(Header("Range") ?? "", "^bytes=(\\d*)-(\\d*)$");
        if (!range.Success || (range.Groups[1].Length == 0 && range.Groups[2].Length == 0))
            return false;
        if (range.Groups[1].Length == 0)
            from = Math.Max(0, length - long.Parse(range.Groups[2].Value, CultureInfo.InvariantCulture));
        else
            from = long.Parse(range.Groups[1].Value, CultureInfo.InvariantCulture);
        long last = range.Groups[1].Length == 0 || range.Groups[2].Length == 0
            ? length - 1
            : Math.Min(length - 1, long.Parse(range.Groups[2].Value, CultureInfo.InvariantCulture));
        bytes = from > last ? -1 : last - from + 1;
        return true;
    }

    // Null at the end of the connection.
    public static async Task<RangeRequest> Read(PipeReader input, CancellationToken ends)
    {
        while (true)
        {
            ReadResult read = await input.ReadAsync(ends);
            int end = HeadEnd(read.Buffer, out string head);
            if (end > 0)
            {
                input.AdvanceTo(read.Buffer.GetPosition(end));
                return Parse(head);
            }
            input.AdvanceTo(read.Buffer.Start, read.Buffer.End);
            if (read.IsCompleted)
                return null;
        }
    }

    static int HeadEnd(ReadOnlySequence<byte> bytes, out string head)
    {
        head = Encoding.ASCII.GetString(bytes);
        int at = head.IndexOf("\r\n\r\n", StringComparison.Ordinal);
        return at < 0 ? 0 : at + 4;
    }

    static RangeRequest Parse(string head)
    {
        string[] lines = head.Substring(0, head.IndexOf("\r\n\r\n", StringComparison.Ordinal)).Split("\r\n");
        string[] first = lines[0].Split(' ');
        var request = new RangeRequest { Method = first[0], Target = first[1] };
        foreach (string line in lines.Skip(1))
        {
            int colon = line.IndexOf(':');
            request.m_headers[line.Substring(0, colon)] = line.Substring(colon + 1).Trim();
        }
        return request;
    }

    public override string ToString() => Method + " " + Target + " " + Header("Range");
}
