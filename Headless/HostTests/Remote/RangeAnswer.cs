using System.IO.Compression;

namespace FastPoints.HostTests.Remote;

enum AnswerEnd { KeepAlive, Close, Reset, Stall, EndlessHead }

// A status, headers, and the range of a file that is the body (zeros where there is no file).
sealed class RangeAnswer
{
    static readonly Dictionary<int, string> s_reasons = new()
    {
        [200] = "OK",
        [206] = "Partial Content",
        [302] = "Found",
        [304] = "Not Modified",
        [404] = "Not Found",
        [405] = "Method Not Allowed",
        [412] = "Precondition Failed",
        [416] = "Range Not Satisfiable",
    };

    public int Status;
    public readonly Dictionary<string, string> Headers = new();
    public string Version = "1.1";
    public string Path;
    public long From, Bytes, Length;
    public byte[] Body; // In place of the file's.
    public string RawHead; // In place of what the status and the headers make; without a body.
    public long SentBytes = -1; // Before what End says; Bytes where it is less than 0.

    // 0: as fast as it goes.
    public int ByteDelayMs;
    public bool IsChunked;
    public AnswerEnd End;

    // As a server answers that makes no faults.
    public static RangeAnswer Of(string folder, RangeRequest request)
    {
        string path = System.IO.Path.GetFullPath(System.IO.Path.Combine(folder, request.Name));
        if (request.Method is not ("GET" or "HEAD"))
            return new RangeAnswer { Status = 405 };
        var file = new FileInfo(path);
        if (!path.StartsWith(folder, StringComparison.Ordinal) || !file.Exists)
            return new RangeAnswer { Status = 404 };
        string tag = "\"" + file.LastWriteTimeUtc.Ticks.ToString("x") + "-" + file.Length.ToString("x") + "\"";
        string modified = file.LastWriteTimeUtc.ToString("R");
        var answer = new RangeAnswer
        {
            Headers = { ["ETag"] = tag, ["Last-Modified"] = modified, ["Accept-Ranges"] = "bytes" },
        };
        if (Differs(request.Header("If-Match"), tag))
            answer.Status = 412;
        else if (request.Header("If-None-Match") == tag)
            answer.Status = 304;
        else
            answer.Take(request, file, Differs(request.Header("If-Range"), tag) && Differs(request.Header("If-Range"), modified));
        return answer;
    }

    static bool Differs(string wanted, string tag) => wanted != null && wanted != tag;

    void Take(RangeRequest request, FileInfo file, bool isWhole)
    {
        bool isRange = request.TryRange(file.Length, out From, out Bytes) && !isWhole;
        Path = file.FullName;
        Length = file.Length;
        if (!isRange)
        {
            (Status, From, Bytes) = (200, 0, file.Length);
            return;
        }
        Status = Bytes < 0 ? 416 : 206;
        Headers["Content-Range"] = Bytes < 0 ? $"bytes */{file.Length}" : $"bytes {From}-{From + Bytes - 1}/{file.Length}";
        Bytes = Math.Max(0, Bytes);
    }

    public void Refuse(int status)
    {
        (Status, Path, Body) = (status, null, Encoding.ASCII.GetBytes("<html>" + status + "</html>"));
        Bytes = Body.Length;
        Headers.Clear();
    }

    public void Redirect(string address)
    {
        Refuse(302);
        Headers["Location"] = address;
    }

    // The range, moved by so many bytes.
    public void SayRange(long start, long end, long total)
    {
        if (Status == 206)
            Headers["Content-Range"] = $"bytes {From + start}-{From + Bytes - 1 + end}/{Length + total}";
    }

    public void Compress()
    {
        if (Path == null)
            return;
        byte[] bytes = new byte[Bytes];
        using (FileStream file = File.OpenRead(Path))
            RandomAccess.Read(file.SafeFileHandle, bytes, From);
        using var compressed = new MemoryStream();
        using (var stream = new GZipStream(compressed, CompressionLevel.Fastest))
            stream.Write(bytes);
        Body = compressed.ToArray();
        Bytes = Body.Length;
        Headers["Content-Encoding"] = "gzip";
    }

    public string Head()
    {
        if (RawHead != null)
            return RawHead;
        var head = new StringBuilder($"HTTP/{Version} {Status} {s_reasons.GetValueOrDefault(Status, "Fault")}\r\n");
        if (IsChunked)
            Headers["Transfer-Encoding"] = "chunked";
        else if (Status != 304 && Version != "1.0")
            Headers.TryAdd("Content-Length", Bytes.ToString(CultureInfo.InvariantCulture));
        foreach ((string name, string value) in Headers)
            head.Append($"{name}: {value}\r\n");
        return head.Append("\r\n").ToString();
    }
}
