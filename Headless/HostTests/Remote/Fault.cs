namespace FastPoints.HostTests.Remote;

// What servers, and what is between, do wrong with one answer. The last few are no faults: clients bear them.
enum Fault
{
    None,
    WholeBody, ShortBody, LongBody, CutBody, ResetBody, StallBody, SlowBody,
    WrongStart, WrongEnd, WrongTotal, NoContentRange, ManyRanges,
    OtherTag, NoTag, OtherDate, Compressed, HugeLength,
    Refused403, Missing404, OutOfRange416, TooMany429, Broken500, Busy503,
    EndlessRedirect, RedirectToHttp, RedirectToNowhere, StallHead, EndlessHead, NotHttp, ResetHead, CloseHead, CutChunks,
    Http10, Chunked, ClosesAfter, Redirect,
}

static class Faults
{
    public static readonly Fault[] All = Enum.GetValues<Fault>().Skip(1).ToArray();

    public static bool IsHarmless(Fault fault) => fault >= Fault.Http10;

    // By the seed, the range and how often it was asked for, so that a run's faults do not depend on the order of threads.
    public static Func<RangeRequest, Fault> Seeded(int seed, double share, params Fault[] kinds)
    {
        var times = new Dictionary<string, int>();
        return request =>
        {
            int time;
            lock (times)
                times[request.ToString()] = (time = times.GetValueOrDefault(request.ToString())) + 1;
            uint hash = 2166136261;
            foreach (char letter in $"{seed} {time} {request}")
                hash = (hash ^ letter) * 16777619;
            var random = new System.Random((int)hash);
            return random.NextDouble() < share ? kinds[random.Next(kinds.Length)] : Fault.None;
        };
    }

    // request: the one that is answered.
    public static void Into(RangeAnswer answer, Fault fault, RangeRequest request)
    {
        Dictionary<string, string> headers = answer.Headers;
        switch (fault)
        {
            case Fault.WholeBody:
                (answer.Status, answer.From, answer.Bytes) = (200, 0, answer.Length);
                headers.Remove("Content-Range");
                break;
            case Fault.ShortBody: answer.Bytes /= 2; break;
            case Fault.LongBody: answer.Bytes += 1000; break;
            case Fault.CutBody: (answer.SentBytes, answer.End) = (answer.Bytes / 2, AnswerEnd.Close); break;
            case Fault.ResetBody: (answer.SentBytes, answer.End) = (answer.Bytes / 2, AnswerEnd.Reset); break;
            case Fault.StallBody: (answer.SentBytes, answer.End) = (answer.Bytes / 2, AnswerEnd.Stall); break;
            case Fault.SlowBody: answer.ByteDelayMs = 50; break;
            case Fault.WrongStart: answer.SayRange(-1, 0, 0); break;
            case Fault.WrongEnd: answer.SayRange(0, 1, 0); break;
            case Fault.WrongTotal: answer.SayRange(0, 0, 1); break;
            case Fault.NoContentRange: headers.Remove("Content-Range"); break;
            case Fault.ManyRanges:
                headers.Remove("Content-Range");
                headers["Content-Type"] = "multipart/byteranges; boundary=b";
                break;
            case Fault.OtherTag: headers["ETag"] = "\"other\""; break;
            case Fault.NoTag: headers.Remove("ETag"); break;
            case Fault.OtherDate: headers["Last-Modified"] = DateTime.UnixEpoch.ToString("R"); break;
            case Fault.Compressed: answer.Compress(); break;
            case Fault.HugeLength: headers["Content-Length"] = long.MaxValue.ToString(CultureInfo.InvariantCulture); break;
            case Fault.Refused403: answer.Refuse(403); break;
            case Fault.Missing404: answer.Refuse(404); break;
            case Fault.OutOfRange416: answer.Refuse(416); break;
            case Fault.TooMany429:
                answer.Refuse(429);
                headers["Retry-After"] = "1";
                break;
            case Fault.Broken500: answer.Refuse(500); break;
            case Fault.Busy503: answer.Refuse(503); break;
            case Fault.EndlessRedirect: answer.Redirect(request.Target.Split('?')[0] + "?again=" + Guid.NewGuid()); break;
            case Fault.RedirectToHttp: answer.Redirect("http://nowhere.invalid/" + request.Name); break;
            case Fault.RedirectToNowhere: answer.Redirect("http://127.0.0.1:1/" + request.Name); break;
            case Fault.Redirect: answer.Redirect("/redirected/" + request.Target.TrimStart('/')); break;
            case Fault.StallHead: (answer.RawHead, answer.End) = ("", AnswerEnd.Stall); break;
            case Fault.EndlessHead:
                (answer.RawHead, answer.End) = ("HTTP/1.1 206 Partial Content\r\n", AnswerEnd.EndlessHead);
                break;
            case Fault.NotHttp: (answer.RawHead, answer.End) = ("220 mail.example.org ESMTP\r\n\r\n", AnswerEnd.Close); break;
            case Fault.ResetHead: (answer.RawHead, answer.End) = ("", AnswerEnd.Reset); break;
            case Fault.CloseHead: (answer.RawHead, answer.End) = ("", AnswerEnd.Close); break;
            case Fault.CutChunks:
                (answer.IsChunked, answer.SentBytes, answer.End) = (true, answer.Bytes / 2, AnswerEnd.Close);
                break;
            case Fault.Http10: (answer.Version, answer.End) = ("1.0", AnswerEnd.Close); break;
            case Fault.Chunked: answer.IsChunked = true; break;
            case Fault.ClosesAfter:
                headers["Connection"] = "close";
                answer.End = AnswerEnd.Close;
                break;
        }
    }
}
