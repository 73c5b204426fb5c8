namespace FastPoints.HostTests.Remote
{
    // A status, headers, and the range of a file that is the body (zeros where there is no file).
    sealed class RangeAnswer
    {
        static readonly Dictionary<int, string> s_reasons = new()
        {
            [200] = "OK", [206] = "Partial Content", [304] = "Not Modified", [404] = "Not Found", [405] = "Method Not Allowed",
            [412] = "Precondition Failed", [416] = "Range Not Satisfiable",
        };

        public int Status;
        public readonly Dictionary<string, string> Headers = new();
        public string Path;
        public long From, Bytes;

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
            if (!isRange)
            {
                (Status, From, Bytes) = (200, 0, file.Length);
                return;
            }
            Status = Bytes < 0 ? 416 : 206;
            Headers["Content-Range"] = Bytes < 0 ? $"bytes */{file.Length}" : $"bytes {From}-{From + Bytes - 1}/{file.Length}";
            Bytes = Math.Max(0, Bytes);
        }

        public string Head()
        {
            var head = new StringBuilder($"HTTP/1.1 {Status} {s_reasons.GetValueOrDefault(Status, "Fault")}\r\n");
            if (Status != 304)
                Headers.TryAdd("Content-Length", Bytes.ToString(CultureInfo.InvariantCulture));
            foreach ((string name, string value) in Headers)
                head.Append($"{name}: {value}\r\n");
            return head.Append("\r\n").ToString();
        }
    }
}
