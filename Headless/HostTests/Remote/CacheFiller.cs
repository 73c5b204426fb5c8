namespace FastPoints.HostTests.Remote;

// Another process, which reads a remote file through the cache until it is killed or has read so often. It writes a line for each
// range that it has, and ends with 1 where a byte is wrong.
static class CacheFiller
{
    static int Main(string[] args)
    {
        (string cache, string address, string original) = (args[0], args[1], args[2]);
        HttpFile.Register();
        RemoteAccess.CacheFolder = cache;
        RemoteAccess.CacheBytes = long.Parse(args[3], CultureInfo.InvariantCulture);
        int reads = int.Parse(args[4], CultureInfo.InvariantCulture);
        var random = new System.Random(int.Parse(args[5], CultureInfo.InvariantCulture));
        byte[] bytes = File.ReadAllBytes(original);
        var file = RemoteFile.Open(address);
        for (int i = 0; i < reads; i++)
        {
            int offset = random.Next(bytes.Length - 1), count = random.Next(1, Math.Min(100_000, bytes.Length - offset));
            byte[] read = new byte[count];
            file.Read(offset, read);
            if (!read.AsSpan().SequenceEqual(bytes.AsSpan(offset, count)))
                return 1;
            SpinWait.SpinUntil(() => RangeQueue.InFlight == 0);
            Console.WriteLine($"{offset} {count}");
        }
        return 0;
    }
}
